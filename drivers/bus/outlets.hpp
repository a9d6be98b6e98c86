#pragma once

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <tuple>
#include <variant>
#include <vector>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/topic.hpp"

/// Selects the messages that are made from the measurements of a device. The receiver may be DDS or
/// a recording. An `Outlet<Message>` feeds one topic: write(Stamp) sends the content of
/// `message()`.
namespace drydock::bus {

/// All messages that are made from one kind of sample.
template <template <class> class Outlet, class Sample, class... Messages>
class SampleOutlets {
 public:
  /// `open.operator()<Message>(topic, frame)` makes an Outlet<Message>.
  template <class Open>
  SampleOutlets(const std::string& device, const Open& open)
      : outlets_(make<Messages>(device, open)...) {}

  /// Each message is sent with the time `received_at`; its header holds `valid_at`.
  void publish(const Sample& sample) {
    for_each([&sample](auto& outlet) {
      if (fill(outlet.message(), sample)) outlet.write(sample.origin.received_at);
    });
  }

  template <class F>
  void for_each(F f) {
    std::apply([&f](auto&... outlet) { (f(outlet), ...); }, outlets_);
  }
  template <class F>
  void for_each(F f) const {
    std::apply([&f](const auto&... outlet) { (f(outlet), ...); }, outlets_);
  }

 private:
  template <class Message, class Open>
  static Outlet<Message> make(const std::string& device, const Open& open) {
    constexpr auto to = route<Sample, Message>;
    return open.template operator()<Message>(topic_name(device, to.suffix),
                                             device + std::string(to.frame));
  }

  std::tuple<Outlet<Messages>...> outlets_;
};

template <template <class> class Outlet>
class GnssOutlets {
 public:
  template <class Open>
  GnssOutlets(const std::string& device, const Open& open)
      : fix_(device, open), satellites_(device, open) {}

  void publish(const GnssFix& sample) { fix_.publish(sample); }
  void publish(const GnssSatellites& sample) { satellites_.publish(sample); }

  template <class F>
  void for_each(F f) const {
    fix_.for_each(f);
    satellites_.for_each(f);
  }

 private:
  SampleOutlets<Outlet, GnssFix, NavSatFixMessage, TwistMessage, GnssFixMessage> fix_;
  SampleOutlets<Outlet, GnssSatellites, GnssSatellitesMessage> satellites_;
};

/// All outlets of one device.
template <template <class> class Outlet>
class DeviceOutlets {
 public:
  template <class Open>
  DeviceOutlets(const Device& device, const Open& open)
      : outlets_(make(device.kind, device.name, open)) {}

  /// False if this kind of device does not give such a measurement.
  bool publish(const Measurement& measurement) {
    return std::visit(
        [](auto& device, const auto& sample) {
          constexpr bool gives = requires { device.publish(sample); };
          if constexpr (gives) device.publish(sample);
          return gives;
        },
        outlets_, measurement);
  }

  template <class F>
  void for_each(F f) const {
    std::visit([&f](const auto& device) { device.for_each(f); }, outlets_);
  }

 private:
  template <class Sample, class... Messages>
  using Of = SampleOutlets<Outlet, Sample, Messages...>;
  using Dvl = Of<BottomVelocity, DvlMessage, TwistMessage, BottomTrackMessage>;
  using EmLog = Of<WaterSpeed, TwistMessage, WaterSpeedMessage>;
  using Imu = Of<ImuSample, ImuMessage>;
  using Depth = Of<DepthSample, FluidPressureMessage, TemperatureMessage, DepthMessage>;
  using Actuator = Of<ActuatorState, ActuatorStateMessage>;
  using Compass = Of<AttitudeSample, AttitudeMessage>;
  using Any = std::variant<Dvl, EmLog, GnssOutlets<Outlet>, Imu, Depth, Actuator, Compass>;

  template <class Open>
  static Any make(Kind kind, const std::string& name, const Open& open) {
    switch (kind) {
      case Kind::dvl: return Dvl(name, open);
      case Kind::emlog: return EmLog(name, open);
      case Kind::gnss: return GnssOutlets<Outlet>(name, open);
      case Kind::imu: return Imu(name, open);
      case Kind::depth: return Depth(name, open);
      case Kind::actuator: return Actuator(name, open);
      case Kind::attitude: return Compass(name, open);
    }
    throw std::invalid_argument("bus: device " + name + " has no known kind");
  }

  Any outlets_;
};

/// Attitude of an estimator, and also its position if the estimator navigates.
template <template <class> class Outlet>
class EstimateOutlets {
 public:
  template <class Open>
  EstimateOutlets(const std::string& name, bool navigates, const Open& open)
      : attitude_(open.template operator()<ImuMessage>(estimate_topic(name), "base_link")) {
    if (!navigates) return;
    odometry_.emplace(open.template operator()<OdometryMessage>(estimate_topic(name) + "/odometry",
                                                                name + "_enu"));
    odometry_->message().child_frame_id = dds_string_dup("base_link");
    fix_.emplace(
        open.template operator()<NavSatFixMessage>(estimate_topic(name) + "/fix", "base_link"));
  }

  void publish(const Attitude& attitude) { write(attitude_, attitude); }
  /// False if the estimator does not navigate.
  bool publish(const Navigation& navigation) {
    if (!odometry_) return false;
    write(*odometry_, navigation);
    write(*fix_, navigation);
    return true;
  }

  template <class F>
  void for_each(F f) const {
    f(attitude_);
    if (odometry_) f(*odometry_);
    if (fix_) f(*fix_);
  }

 private:
  template <class Message, class Estimate>
  static void write(Outlet<Message>& outlet, const Estimate& estimate) {
    fill(outlet.message(), estimate);
    outlet.write(estimate.valid_at);
  }

  Outlet<ImuMessage> attitude_;
  std::optional<Outlet<OdometryMessage>> odometry_;
  std::optional<Outlet<NavSatFixMessage>> fix_;
};

/// One for each of `names`. Those that are also in `navigators` give Navigation.
template <template <class> class Outlet, class Open>
std::vector<EstimateOutlets<Outlet>> open_estimates(const std::vector<std::string>& names,
                                                    const std::vector<std::string>& navigators,
                                                    const Open& open) {
  std::vector<EstimateOutlets<Outlet>> all;
  all.reserve(names.size());
  for (const auto& name : names)
    all.emplace_back(name, std::ranges::find(navigators, name) != navigators.end(), open);
  return all;
}

}  // namespace drydock::bus
