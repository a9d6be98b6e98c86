#pragma once

#include <stdexcept>
#include <tuple>
#include <variant>

#include "drivers/bus/convert.hpp"
#include "drivers/bus/topic.hpp"

/// Which messages are made of a device's measurements, whatever takes them: DDS, a recording.
/// An `Outlet<Message>` takes one topic: `message()` is what write(Stamp) sends.
namespace drydock::bus {

/// Everything that one kind of sample becomes.
template <template <class> class Outlet, class Sample, class... Messages>
class SampleOutlets {
 public:
  /// `open.operator()<Message>(topic, frame)` makes an Outlet<Message>.
  template <class Open>
  SampleOutlets(const std::string& device, const Open& open)
      : outlets_(make<Messages>(device, open)...) {}

  /// The time that goes with each message is `received_at`; `valid_at` is in its header.
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

  /// False when this kind of device does not give such a measurement.
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
  using Any = std::variant<Dvl, EmLog, GnssOutlets<Outlet>, Imu, Depth, Actuator>;

  template <class Open>
  static Any make(Kind kind, const std::string& name, const Open& open) {
    switch (kind) {
      case Kind::dvl: return Dvl(name, open);
      case Kind::emlog: return EmLog(name, open);
      case Kind::gnss: return GnssOutlets<Outlet>(name, open);
      case Kind::imu: return Imu(name, open);
      case Kind::depth: return Depth(name, open);
      case Kind::actuator: return Actuator(name, open);
    }
    throw std::invalid_argument("bus: device " + name + " has no known kind");
  }

  Any outlets_;
};

}  // namespace drydock::bus
