#include "drivers/device/imu/sbg_imu_driver.hpp"

#include "drivers/device/imu/lost_message.hpp"

namespace drydock::device {

namespace {

namespace sbg = wire::sbg;

ImuPair::Components components_of(const std::array<double, 3>& axes) {
  return {axes[0], axes[1], axes[2]};
}

}  // namespace

SbgImuDriver::SbgImuDriver(const DriverOptions& options)
    : BusDriver(options), mounting_(options.mounting), clock_(std::chrono::microseconds{1}) {}

void SbgImuDriver::restart(Stamp, Output&) {
  pair_.reset();
  clock_.reset();
  group_.reset();
  order_.reset();
  late_.reset();
  timed_ = false;
}

void SbgImuDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame);
  if (!message) return;
  const Origin origin = timing_.of_frame(received_at, frame);
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

void SbgImuDriver::on(const sbg::ImuInfo& m, const Origin& origin, Output& out) {
  // Were frames between the two halves lost, then so was the time of the group of the second.
  const bool follows = order_.follows(m.time_us);
  if (late_ && follows) out.publish(*late_);
  if ((late_ && !follows) || (timed_ && !late_ && pair_.begun())) report_lost_message(out);
  late_.reset();
  pair_.reset();
  timed_ = true;
  group_ = clock_.map(m.time_us, origin.valid_at);
}

void SbgImuDriver::on(const sbg::ImuAcceleration& m, const Origin& origin, Output& out) {
  pair_.set_force(origin, components_of(m.value));
  join(out);
}

void SbgImuDriver::on(const sbg::ImuRate& m, const Origin& origin, Output& out) {
  Origin timed = origin;
  if (group_) timed.device_time = group_->device;
  pair_.set_rate(timed, components_of(m.value));
  if (group_) pair_.state(group_->host);
  group_.reset();
  join(out);
}

void SbgImuDriver::join(Output& out) {
  if (timed_ && pair_.whole() && pair_.is_late())
    late_ = pair_.take(mounting_);
  else
    pair_.publish(mounting_, out);
}

}  // namespace drydock::device
