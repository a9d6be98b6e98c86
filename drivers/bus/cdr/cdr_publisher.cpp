#include "drivers/bus/cdr/cdr_publisher.hpp"

#include "drivers/bus/cdr/cdr_outlet.hpp"
#include "drivers/bus/outlets.hpp"

namespace drydock::bus {

struct CdrPublisher::Topics {
  Topics(CdrSink& sink, const std::vector<Device>& of, const std::vector<std::string>& estimators,
         const std::vector<std::string>& navigators, const std::vector<InnovationSource>& sources)
      : diagnostics(sink, encoder, std::string(diagnostics_topic), ""),
        faults(sink, encoder, std::string(faults_topic), "") {
    const auto open = [&]<class Message>(const std::string& topic, const std::string& frame) {
      return CdrOutlet<Message>(sink, encoder, topic, frame);
    };
    for (const auto& device : of) devices.emplace_back(device, open);
    estimates = open_estimates<CdrOutlet>(estimators, navigators, open);
    for (const auto& source : sources) {
      const auto& device = of.at(source.device);
      const auto topic = innovation_topic(estimators.at(source.estimator), device.name);
      innovations.push_back({source, {sink, encoder, topic, ""}});
      describe(innovations.back().outlet.message(), device);
    }
  }

  struct InnovationOutlet {
    InnovationSource of;
    CdrOutlet<InnovationMessage> outlet;
  };

  CdrEncoder encoder;
  std::vector<DeviceOutlets<CdrOutlet>> devices;
  std::vector<EstimateOutlets<CdrOutlet>> estimates;
  std::vector<InnovationOutlet> innovations;
  CdrOutlet<DiagnosticsMessage> diagnostics;
  CdrOutlet<FaultsMessage> faults;
};

CdrPublisher::CdrPublisher(CdrSink& sink, const std::vector<Device>& devices,
                           const std::vector<std::string>& estimators,
                           const std::vector<std::string>& navigators,
                           const std::vector<InnovationSource>& innovations)
    : topics_(std::make_unique<Topics>(sink, devices, estimators, navigators, innovations)) {}

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

void CdrPublisher::publish(const Innovation& innovation) {
  for (auto& [of, outlet] : topics_->innovations) {
    if (of.estimator != innovation.estimator || of.device != innovation.device) continue;
    fill(outlet.message(), innovation);
    outlet.write(innovation.valid_at);
  }
}

void CdrPublisher::publish(std::span<const Fault> faults, Stamp now) {
  fill(topics_->faults.message(), faults, now);
  topics_->faults.write(now);
}

}  // namespace drydock::bus
