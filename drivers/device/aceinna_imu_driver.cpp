#include "drivers/device/aceinna_imu_driver.hpp"

#include <algorithm>

#include "drivers/device/imu_sample.hpp"

namespace drydock::device {

namespace {
/// The device sends its messages within 0.8 ms; half the period of 100 Hz still tells two apart.
constexpr std::chrono::milliseconds pairing_window{5};
}  // namespace

AceinnaImuDriver::AceinnaImuDriver(const DriverOptions& options)
    : BusDriver(options), mounting_(options.mounting), source_(options.address) {}

void AceinnaImuDriver::restart(Stamp, Output&) {
  rate_.reset();
  force_.reset();
}

void AceinnaImuDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame);
  if (!message) return;
  if (const auto* ari = std::get_if<wire::aceinna::AngularRate>(&*message)) {
    if (!source_.accepts(ari->source, received_at)) return;
    rate_ = Half{timing_.of_frame(received_at, frame), ari->rate_radps};
    if (ari->latency_s) {
      stated_valid_at_ =
          timing_.of_frame(received_at, frame, measurement::from_seconds(*ari->latency_s)).valid_at;
    } else {
      stated_valid_at_.reset();
    }
    pair(out);
  } else if (const auto* accs = std::get_if<wire::aceinna::Acceleration>(&*message)) {
    if (!source_.accepts(accs->source, received_at)) return;
    force_ = Half{timing_.of_frame(received_at, frame), accs->acceleration_mps2};
    pair(out);
  }
}

void AceinnaImuDriver::pair(Output& out) {
  if (!rate_ || !force_) return;
  const auto apart = rate_->origin.received_at - force_->origin.received_at;
  if (std::chrono::abs(apart) > pairing_window) return;  // the older one waits in vain
  // Sampled together, before the first of the two left.
  Origin origin = rate_->origin;
  origin.received_at = std::max(origin.received_at, force_->origin.received_at);
  origin.valid_at = stated_valid_at_.value_or(std::min(origin.valid_at, force_->origin.valid_at));
  const auto sample = make_imu_sample(origin, rate_->components, force_->components, mounting_);
  rate_.reset();
  force_.reset();
  if (sample) out.publish(*sample);
}

}  // namespace drydock::device
