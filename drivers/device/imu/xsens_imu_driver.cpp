#include "drivers/device/imu/xsens_imu_driver.hpp"

#include "drivers/device/imu/imu_sample.hpp"

namespace drydock::device {

namespace {

namespace xsens = wire::xsens;

constexpr std::chrono::microseconds tick_length{100};
constexpr std::chrono::milliseconds longest_group{5};
constexpr std::chrono::seconds plain_counts_for{1};
constexpr std::uint8_t output_buffer_overflow = 1;

std::array<std::optional<double>, 3> all_there(const std::array<double, 3>& axes) {
  return {axes[0], axes[1], axes[2]};
}

}  // namespace

XsensImuDriver::XsensImuDriver(const DriverOptions& options)
    : BusDriver(options, wire::Xsens::Decoder{options.xsens_identifiers}),
      mounting_(options.mounting),
      clock_(tick_length) {}

void XsensImuDriver::restart(Stamp, Output&) {
  group_ = {};
  order_.reset();
  last_counter_.reset();
  late_.reset();
  marked_ = false;
  plain_at_.reset();
  clock_.reset();
}

void XsensImuDriver::receive(const wire::CanFrame& frame, Stamp received_at, Output& out) {
  const auto message = decoder_.receive(frame);
  if (!message) return;
  const Origin origin = timing_.of_frame(received_at, frame);
  std::visit(
      [&](const auto& m) {
        if constexpr (requires { on(m, origin, out); }) on(m, origin, out);
      },
      *message);
}

void XsensImuDriver::begin_group(const Origin& origin) {
  group_ = {};
  group_.first = origin;
  marked_ = true;
}

void XsensImuDriver::on(const xsens::SampleTime& m, const Origin& origin, Output&) {
  if (!group_.first || group_.ticks || group_.has_data()) begin_group(origin);
  group_.ticks = m.ticks;
  group_.follows = order_.follows(m.ticks);
}

void XsensImuDriver::on(const xsens::GroupCounter& m, const Origin& origin, Output&) {
  if (!group_.first || group_.counter || group_.has_data()) begin_group(origin);
  group_.counter = m.counter;
  // It says more than the ticks do.
  group_.follows = last_counter_ && m.counter == static_cast<std::uint16_t>(*last_counter_ + 1);
  last_counter_ = m.counter;
}

void XsensImuDriver::on(const xsens::StatusWord& m, const Origin&, Output& out) {
  group_.clipped = m.acceleration_clipped() || m.rate_clipped();
  tell(!m.self_test_passed(), told_self_test_, "the IMU failed its self-test", out);
  tell(group_.clipped, told_clipped_, "acceleration or rate beyond the IMU's range", out);
}

void XsensImuDriver::on(const xsens::Error& m, const Origin&, Output& out) {
  if (m.code == output_buffer_overflow) {
    out.report("the IMU dropped a message: its output is more than the bus carries");
  } else {
    out.report("the IMU reports an error that its manual does not name");
  }
}

void XsensImuDriver::on(const xsens::RateOfTurn& m, const Origin& origin, Output& out) {
  plain_at_ = origin.received_at;
  add(&Group::rate, m.value, origin, out);
}

void XsensImuDriver::on(const xsens::Acceleration& m, const Origin& origin, Output& out) {
  plain_at_ = origin.received_at;
  add(&Group::force, m.value, origin, out);
}

void XsensImuDriver::on(const xsens::RateOfTurnHr& m, const Origin& origin, Output& out) {
  if (!plain_comes(origin.received_at)) add(&Group::rate, m.value, origin, out);
}

void XsensImuDriver::on(const xsens::AccelerationHr& m, const Origin& origin, Output& out) {
  if (!plain_comes(origin.received_at)) add(&Group::force, m.value, origin, out);
}

bool XsensImuDriver::plain_comes(Stamp now) const {
  return plain_at_ && now - *plain_at_ < plain_counts_for;
}

void XsensImuDriver::add(std::optional<Axes> Group::*which, const Axes& axes, const Origin& origin,
                         Output& out) {
  const bool late = group_.first && origin.received_at - group_.first->received_at > longest_group;
  const bool repeated = (group_.*which).has_value();
  if (marked_) {
    if (!group_.has_data()) judge_late(out);
    if (repeated) group_.whole = true;  // it belongs to a group whose beginning was lost
    if (group_.whole) return;
    group_.late = late;
  } else if (!group_.first || late || repeated || group_.whole) {
    group_ = {};
    group_.first = origin;
  }
  group_.*which = axes;
  if (group_.rate && group_.force) publish(origin, out);
}

/// Were frames between the two halves lost, then so was the beginning of the group of the second.
void XsensImuDriver::judge_late(Output& out) {
  if (late_ && group_.follows) out.publish(*late_);
  if (late_ && !group_.follows)
    out.refuse("a sample read late was left out: a group behind it was lost", Refusal::incomplete);
  late_.reset();
}

void XsensImuDriver::publish(const Origin& last, Output& out) {
  group_.whole = true;
  Origin origin = *group_.first;
  origin.received_at = last.received_at;
  if (group_.ticks) {
    const auto time = clock_.map(*group_.ticks, origin.valid_at);
    origin.device_time = time.device;
    origin.valid_at = time.host;
  }
  if (group_.clipped) return;
  const auto sample =
      make_imu_sample(origin, all_there(*group_.rate), all_there(*group_.force), mounting_);
  if (sample && group_.late)
    late_ = sample;
  else if (sample)
    out.publish(*sample);
}

/// Reports each error once, when it begins.
void XsensImuDriver::tell(bool trouble, bool& told, std::string_view words, Output& out) const {
  if (trouble && !told) out.report(words);
  told = trouble;
}

}  // namespace drydock::device
