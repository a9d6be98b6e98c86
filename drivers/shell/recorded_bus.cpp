#include "drivers/shell/recorded_bus.hpp"

#include <stdexcept>

#include "drivers/link/can/frame_file.hpp"

namespace drydock::shell {

namespace {
/// 8 bytes with a 29-bit identifier and a typical number of stuff bits.
constexpr std::chrono::nanoseconds bits_of_a_frame{140};
constexpr std::int64_t per_second = 1'000'000'000;
}  // namespace

RecordedBus::RecordedBus(const link::Uri& uri, std::vector<DeviceActor*> drivers, Stamp start,
                         RecordingClock clock)
    : file_(link::capture_of(uri)),
      drivers_(std::move(drivers)),
      clock_(std::move(clock)),
      frame_on_a_full_bus_(bits_of_a_frame * per_second / *uri.bitrate()),
      start_(start),
      due_(start) {
  read_next();
  if (const std::string trouble = file_.trouble(); !trouble.empty()) {
    throw std::runtime_error(trouble);
  }
}

std::optional<Stamp> RecordedBus::deadline() const {
  return frame_ ? std::optional(due_) : std::nullopt;
}

void RecordedBus::act(Stamp now) {
  for (DeviceActor* driver : drivers_) driver->receive(*frame_, now);
  read_next();
  if (frame_) return;
  for (DeviceActor* driver : drivers_) driver->end_of_recording(now);
}

std::vector<std::string> RecordedBus::notes() const {
  std::vector<std::string> all;
  for (auto note : {std::string(file_.frames().note()), file_.times().in_words()})
    if (!note.empty()) all.push_back(std::move(note));
  return all;
}

void RecordedBus::read_next() {
  const auto record = file_.next();
  frame_.reset();
  if (!record) return;
  frame_ = record->frame;
  ++frames_;
  due_ = due_of(*record);
}

/// The frames of a message come at its time, those behind the last one at once.
Stamp RecordedBus::due_of(const capture::Record& record) {
  const auto& messages = clock_.times.messages;
  while (message_ < messages.size() && messages[message_].through < frames_) ++message_;
  switch (clock_.pace) {
    case Pace::arrival:
      if (record.time) return start_ + (Stamp{*record.time} - clock_.first);
      break;
    case Pace::device:
      if (message_ == messages.size()) return due_;
      return start_ + (Stamp{messages[message_].at} - clock_.first);
    case Pace::line: break;
  }
  return due_ + frame_on_a_full_bus_;
}

}  // namespace drydock::shell
