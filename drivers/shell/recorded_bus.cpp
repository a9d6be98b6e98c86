#include "drivers/shell/recorded_bus.hpp"

#include <stdexcept>

#include "drivers/link/can/frame_file.hpp"

namespace drydock::shell {

namespace {
/// 8 bytes with a 29-bit identifier and a typical number of stuff bits, at 250 kbit/s.
constexpr std::chrono::microseconds frame_on_a_full_bus{560};
}  // namespace

RecordedBus::RecordedBus(const link::Uri& uri, DeviceActor& driver, Stamp start)
    : file_(link::capture_of(uri)), driver_(driver), start_(start), due_(start) {
  read_next();
  if (const std::string trouble = file_.trouble(); !trouble.empty()) {
    throw std::runtime_error(trouble);
  }
}

std::optional<Stamp> RecordedBus::deadline() const {
  return frame_ ? std::optional(due_) : std::nullopt;
}

void RecordedBus::act(Stamp now) {
  driver_.receive(*frame_, now);
  read_next();
}

void RecordedBus::read_next() {
  const auto record = file_.next();
  frame_.reset();
  if (!record) return;
  frame_ = record->frame;
  if (record->time && !first_time_) first_time_ = record->time;
  due_ = record->time ? start_ + (*record->time - *first_time_) : due_ + frame_on_a_full_bus;
}

}  // namespace drydock::shell
