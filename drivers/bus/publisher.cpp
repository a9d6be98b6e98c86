#include "drivers/bus/publisher.hpp"

#include "drivers/bus/outlets.hpp"
#include "drivers/bus/writer.hpp"

namespace drydock::bus {
namespace {

struct Channel {
  Provenance provenance;
  DeviceOutlets<Writer> outlets;
};

}  // namespace

struct Publisher::Writers {
  std::vector<Channel> devices;
  std::vector<EstimateOutlets<Writer>> estimates;
  Writer<DiagnosticsMessage> diagnostics;
  std::uint64_t misrouted = 0;

  template <class F>
  void for_each(F f) const {
    for (const auto& device : devices) device.outlets.for_each(f);
    for (const auto& estimate : estimates) estimate.for_each(f);
    f(diagnostics);
  }
};

Publisher::Publisher(const Participant& participant, const std::vector<Device>& devices,
                     const std::vector<std::string>& estimators,
                     const std::vector<std::string>& navigators)
    : writers_(new Writers{.devices = {},
                           .estimates = {},
                           .diagnostics = {participant, std::string(diagnostics_topic), ""}}) {
  writers_->devices.reserve(devices.size());
  for (const auto& device : devices) {
    const auto open = [&]<class Message>(const std::string& topic, const std::string& frame) {
      return Writer<Message>(participant, topic, frame, to_string(device.provenance));
    };
    writers_->devices.push_back({device.provenance, {device, open}});
  }
  const auto open = [&]<class Message>(const std::string& topic, const std::string& frame) {
    return Writer<Message>(participant, topic, frame);
  };
  writers_->estimates = open_estimates<Writer>(estimators, navigators, open);
}

Publisher::Publisher(Publisher&&) noexcept = default;
Publisher& Publisher::operator=(Publisher&&) noexcept = default;
Publisher::~Publisher() = default;

void Publisher::publish(const Measurement& measurement) {
  const auto& origin = origin_of(measurement);
  const bool known = origin.device < writers_->devices.size() &&
                     writers_->devices[origin.device].provenance == origin.provenance;
  if (!known || !writers_->devices[origin.device].outlets.publish(measurement)) {
    ++writers_->misrouted;
  }
}

void Publisher::publish(const Attitude& attitude, std::size_t estimator) {
  const bool known = estimator < writers_->estimates.size();
  if (known) writers_->estimates[estimator].publish(attitude);
  if (!known) ++writers_->misrouted;
}

void Publisher::publish(const Navigation& navigation, std::size_t estimator) {
  const bool known =
      estimator < writers_->estimates.size() && writers_->estimates[estimator].publish(navigation);
  if (!known) ++writers_->misrouted;
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

bool Publisher::wait_for_readers(std::chrono::nanoseconds longest) const {
  bool all = true;
  writers_->for_each([&](const auto& writer) { all = writer.wait_for_readers(longest) && all; });
  return all;
}

std::vector<TopicCounters> Publisher::counters() const {
  std::vector<TopicCounters> all;
  writers_->for_each([&all](const auto& writer) { all.push_back(writer.counters()); });
  return all;
}

std::uint64_t Publisher::misrouted() const { return writers_->misrouted; }

}  // namespace drydock::bus
