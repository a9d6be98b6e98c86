#include "drivers/shell/recorded_line.hpp"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace drydock::shell {
namespace {

constexpr unsigned default_baud = 9600;
constexpr std::size_t bytes_per_step = 64, bytes_at_once = 65536;

/// Throws where a file of packets has no such line, or several and none was chosen.
void refuse_no_line(const link::Uri& uri) {
  capture::LineFile line(uri.target, false, std::string(uri.text_of("interface")));
  line.next();
  if (const auto trouble = line.trouble(); !trouble.empty()) throw std::runtime_error(trouble);
}

}  // namespace

RecordedLine::RecordedLine(const link::Uri& uri, std::vector<DeviceActor*> drivers, Stamp start,
                           RecordingClock clock)
    : file_(uri.target, uri.text_of("format") == "raw", std::string(uri.text_of("interface"))),
      drivers_(std::move(drivers)),
      start_(start),
      clock_(std::move(clock)),
      rate_(uri.line_rate().value_or(wire::LineRate{})) {
  if (file_.error() != 0) {
    throw std::runtime_error("cannot open the recording " + uri.target + ": " +
                             std::strerror(file_.error()));
  }
  if (uri.text_of("format") != "raw" && capture::has_packets(uri.target)) refuse_no_line(uri);
  if (clock_.pace == Pace::arrival)
    begin_packets(uri);
  else
    schedule(start);
}

void RecordedLine::begin_packets(const link::Uri& uri) {
  packets_ =
      std::make_unique<capture::LineFile>(uri.target, false, std::string(uri.text_of("interface")));
  const auto first = packets_->next();
  if (!first) return;
  read_ = *first;
  next_ = std::max(start_, due());
}

void RecordedLine::deliver(wire::Bytes bytes, Stamp now) {
  for (DeviceActor* driver : drivers_) driver->receive(bytes, now);
}

/// The last line of a recording may have no end, and a sentence waits for it.
void RecordedLine::end(Stamp now) {
  constexpr std::uint8_t line_end[] = {'\n'};
  next_.reset();
  if (std::ranges::any_of(drivers_, [](const DeviceActor* driver) {
        return driver->device().vitals().held_bytes > 0;
      }))
    deliver(line_end, now);
  for (DeviceActor* driver : drivers_) driver->end_of_recording(now);
}

/// A read that came before the one in front of it comes at once.
void RecordedLine::act_on_packet(Stamp now) {
  deliver(read_.bytes, now);
  next_.reset();
  const auto following = packets_->next();
  if (!following) return end(now);
  read_ = *following;
  next_ = std::max(now, due());
}

Stamp RecordedLine::due() const {
  const Stamp::duration time = read_.time.value_or(Stamp::duration{0}) + clock_.date;
  return start_ + (time - clock_.first.time_since_epoch());
}

void RecordedLine::act(Stamp now) {
  if (packets_) return act_on_packet(now);
  chunk_.resize(next_bytes());
  const std::size_t n = file_.read(chunk_);
  if (n == 0) return end(now);
  delivered_ += n;
  deliver(wire::Bytes(chunk_).first(n), now);
  if (message_ < clock_.times.messages.size()) ++message_;
  schedule(now);
}

std::vector<std::string> RecordedLine::notes() const {
  std::vector<std::string> all;
  if (!packets_) return all;
  for (auto note : {packets_->damage(), packets_->cut_note(), packets_->clock_note()})
    if (!note.empty()) all.push_back(std::move(note));
  return all;
}

std::size_t RecordedLine::next_bytes() const {
  const auto& messages = clock_.times.messages;
  if (message_ < messages.size())
    return static_cast<std::size_t>(messages[message_].through - delivered_);
  return clock_.pace == Pace::device ? bytes_at_once : bytes_per_step;
}

void RecordedLine::schedule(Stamp now) {
  const auto& messages = clock_.times.messages;
  if (message_ < messages.size()) {
    const auto& message = messages[message_];
    next_ = std::max(now, start_ + (message.at - messages.front().at) +
                              rate_.time_of(static_cast<std::size_t>(message.bytes)));
    return;
  }
  next_ = now;  // what is behind the last message that tells a time comes at once
  if (clock_.pace == Pace::device) return;
  const wire::LineRate line = rate_.baud > 0 ? rate_ : wire::LineRate{default_baud};
  *next_ += line.time_of(1) * static_cast<std::int64_t>(bytes_per_step);
}

}  // namespace drydock::shell
