#pragma once

#include <string>
#include <string_view>

#include "drivers/bus/device.hpp"
#include "drivers/bus/message_types.hpp"

/// Which topic carries which message: `rt/<device>/<suffix>`, in frame `<device><frame>`. Frames:
/// `_link` forward-left-up (REP-103), `_link_frd` forward-right-down, `_enu` east-north-up.
namespace drydock::bus {

struct Route {
  std::string_view suffix;
  std::string_view frame;
};

template <class Sample, class Message>
inline constexpr Route route{};

template <>
inline constexpr Route route<measurement::ImuSample, ImuMessage>{"data", "_link"};

template <>
inline constexpr Route route<measurement::BottomVelocity, DvlMessage>{"data", "_link_frd"};
template <>
inline constexpr Route route<measurement::BottomVelocity, TwistMessage>{"twist", "_link"};
template <>
inline constexpr Route route<measurement::BottomVelocity, BottomTrackMessage>{"bottom_track",
                                                                              "_link_frd"};

template <>
inline constexpr Route route<measurement::WaterSpeed, TwistMessage>{"twist", "_link"};
template <>
inline constexpr Route route<measurement::WaterSpeed, WaterSpeedMessage>{"speed", "_link_frd"};

template <>
inline constexpr Route route<measurement::GnssFix, NavSatFixMessage>{"fix", "_link"};
template <>
inline constexpr Route route<measurement::GnssFix, TwistMessage>{"velocity", "_enu"};
template <>
inline constexpr Route route<measurement::GnssFix, GnssFixMessage>{"solution", "_link"};
template <>
inline constexpr Route route<measurement::GnssSatellites, GnssSatellitesMessage>{"satellites",
                                                                                 "_link"};

template <>
inline constexpr Route route<measurement::DepthSample, FluidPressureMessage>{"pressure", "_link"};
template <>
inline constexpr Route route<measurement::DepthSample, TemperatureMessage>{"temperature", "_link"};
template <>
inline constexpr Route route<measurement::DepthSample, DepthMessage>{"depth", "_link"};

template <>
inline constexpr Route route<measurement::ActuatorState, ActuatorStateMessage>{"state", "_link"};

template <>
inline constexpr Route route<measurement::AttitudeSample, AttitudeMessage>{"attitude", "_link_frd"};

inline constexpr std::string_view diagnostics_topic = "rt/diagnostics";

/// Only in recordings and viewers, not on DDS.
inline constexpr std::string_view faults_topic = "rt/drydock/faults";

inline std::string innovation_topic(std::string_view estimator, std::string_view device) {
  return "rt/drydock/" + std::string(estimator) + "/innovation/" + std::string(device);
}

inline std::string topic_name(std::string_view device, std::string_view suffix) {
  return "rt/" + std::string(device) + "/" + std::string(suffix);
}
inline std::string estimate_topic(std::string_view estimator) {
  return "rt/estimate/" + std::string(estimator);
}

}  // namespace drydock::bus
