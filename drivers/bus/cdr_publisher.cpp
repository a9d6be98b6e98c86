#include "drivers/bus/cdr_publisher.hpp"

#include "drivers/bus/cdr_outlet.hpp"
#include "drivers/bus/outlets.hpp"

namespace drydock::bus {

struct CdrPublisher::Topics {
  Topics(CdrSink& sink, const std::vector<Device>& of, const std::vector<std::string>& estimators,
         const std::vector<std::string>& navigators)
      : diagnostics(sink, encoder, std::string(diagnostics_topic), "") {
    const auto open = [&]<class Message>(const std::string& topic, const std::string& frame) {
      return CdrOutlet<Message>(sink, encoder, topic, frame);
    };
    for (const auto& device : of) devices.emplace_back(device, open);
    estimates = open_estimates<CdrOutlet>(estimators, navigators, open);
  }

  CdrEncoder encoder;
  std::vector<DeviceOutlets<CdrOutlet>> devices;
  std::vector<EstimateOutlets<CdrOutlet>> estimates;
  CdrOutlet<DiagnosticsMessage> diagnostics;
};

CdrPublisher::CdrPublisher(CdrSink& sink, const std::vector<Device>& devices,
                           const std::vector<std::string>& estimators,
                           const std::vector<std::string>& navigators)
    : topics_(std::make_unique<Topics>(sink, devices, estimators, navigators)) {}

CdrPublisher::CdrPublisher(CdrPublisher&&) noexcept = default;
CdrPublisher& CdrPublisher::operator=(CdrPublisher&&) noexcept = default;
CdrPublisher::~CdrPublisher() = default;

void CdrPublisher::publish(const Measurement& measurement) {
  const auto device = measurement::origin_of(measurement).device;
  if (device < topics_->devices.size()) topics_->devices[device].publish(measurement);
}

void CdrPublisher::publish(const Attitude& attitude, std::size_t estimator) {
  if (estimator < topics_->estimates.size()) topics_->estimates[estimator].publish(attitude);
}

void CdrPublisher::publish(const Navigation& navigation, std::size_t estimator) {
  if (estimator < topics_->estimates.size()) topics_->estimates[estimator].publish(navigation);
}

void CdrPublisher::publish(std::span<const DeviceStatus> health, Stamp now) {
  fill(topics_->diagnostics.message(), health, now);
  topics_->diagnostics.write(now);
}

}  // namespace drydock::bus
