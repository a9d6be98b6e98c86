#include "drivers/bus/publisher.hpp"

#include <algorithm>
#include <optional>

#include "drivers/bus/writer.hpp"

namespace drydock::bus {
namespace {

/// The alternatives stand in the order of Kind.
using DeviceWriters =
    std::variant<DvlWriters, EmLogWriters, GnssWriters, ImuWriters, DepthWriters, ActuatorWriters>;

DeviceWriters make_writers(const Participant& participant, const Device& device) {
  switch (device.kind) {
    case Kind::dvl: return DvlWriters(participant, device);
    case Kind::emlog: return EmLogWriters(participant, device);
    case Kind::gnss: return GnssWriters(participant, device);
    case Kind::imu: return ImuWriters(participant, device);
    case Kind::depth: return DepthWriters(participant, device);
    case Kind::actuator: return ActuatorWriters(participant, device);
  }
  throw std::invalid_argument("bus: device " + device.name + " has no known kind");
}

struct Channel {
  Provenance provenance;
  DeviceWriters writers;
};

struct NavigationWriters {
  NavigationWriters(const Participant& participant, const std::string& estimator)
      : odometry(participant, estimate_topic(estimator) + "/odometry", estimator + "_enu"),
        fix(participant, estimate_topic(estimator) + "/fix", "base_link") {
    odometry.message().child_frame_id = dds_string_dup("base_link");
  }
  Writer<OdometryMessage> odometry;
  Writer<NavSatFixMessage> fix;
};

/// False when this kind of device does not give such a measurement.
bool publish_to(DeviceWriters& writers, const Measurement& measurement) {
  return std::visit(
      [](auto& device, const auto& sample) {
        constexpr bool gives = requires { device.publish(sample); };
        if constexpr (gives) device.publish(sample);
        return gives;
      },
      writers, measurement);
}

}  // namespace

struct Publisher::Writers {
  std::vector<Channel> devices;
  std::vector<Writer<ImuMessage>> estimates;
  std::vector<std::optional<NavigationWriters>> navigation;  ///< one an estimator
  Writer<DiagnosticsMessage> diagnostics;
  std::uint64_t misrouted = 0;

  template <class F>
  void for_each(F f) const {
    for (const auto& device : devices) {
      std::visit([&f](const auto& writers) { writers.for_each(f); }, device.writers);
    }
    for (const auto& estimate : estimates) f(estimate);
    for (const auto& writers : navigation) {
      if (!writers) continue;
      f(writers->odometry);
      f(writers->fix);
    }
    f(diagnostics);
  }
};

Publisher::Publisher(const Participant& participant, const std::vector<Device>& devices,
                     const std::vector<std::string>& estimators,
                     const std::vector<std::string>& navigators)
    : writers_(new Writers{.devices = {},
                           .estimates = {},
                           .navigation = {},
                           .diagnostics = {participant, std::string(diagnostics_topic), ""}}) {
  writers_->devices.reserve(devices.size());
  for (const auto& device : devices) {
    writers_->devices.push_back({device.provenance, make_writers(participant, device)});
  }
  for (const auto& name : estimators) {
    writers_->estimates.emplace_back(participant, estimate_topic(name), "base_link");
    auto& navigation = writers_->navigation.emplace_back();
    if (std::ranges::find(navigators, name) != navigators.end())
      navigation.emplace(participant, name);
  }
}

Publisher::Publisher(Publisher&&) noexcept = default;
Publisher& Publisher::operator=(Publisher&&) noexcept = default;
Publisher::~Publisher() = default;

void Publisher::publish(const Measurement& measurement) {
  const auto& origin = origin_of(measurement);
  const bool known = origin.device < writers_->devices.size() &&
                     writers_->devices[origin.device].provenance == origin.provenance;
  if (!known || !publish_to(writers_->devices[origin.device].writers, measurement)) {
    ++writers_->misrouted;
  }
}

void Publisher::publish(const Attitude& attitude, std::size_t estimator) {
  if (estimator >= writers_->estimates.size()) {
    ++writers_->misrouted;
    return;
  }
  auto& writer = writers_->estimates[estimator];
  fill(writer.message(), attitude);
  writer.write(attitude.valid_at);
}

void Publisher::publish(const Navigation& navigation, std::size_t estimator) {
  if (estimator >= writers_->navigation.size() || !writers_->navigation[estimator]) {
    ++writers_->misrouted;
    return;
  }
  const auto write = [&](auto& writer) {
    fill(writer.message(), navigation);
    writer.write(navigation.valid_at);
  };
  write(writers_->navigation[estimator]->odometry);
  write(writers_->navigation[estimator]->fix);
}

void Publisher::publish(std::span<const DeviceStatus> health, Stamp now) {
  auto& writer = writers_->diagnostics;
  fill(writer.message(), health, now);
  writer.write(now);
}

std::size_t Publisher::matched_readers() const {
  std::size_t count = 0;
  writers_->for_each([&count](const auto& writer) { count += writer.matched(); });
  return count;
}

std::vector<TopicCounters> Publisher::counters() const {
  std::vector<TopicCounters> all;
  writers_->for_each([&all](const auto& writer) { all.push_back(writer.counters()); });
  return all;
}

std::uint64_t Publisher::misrouted() const { return writers_->misrouted; }

}  // namespace drydock::bus
