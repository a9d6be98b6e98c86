#include "drivers/shell/recorded_line.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <stdexcept>

namespace drydock::shell {
namespace {

constexpr unsigned default_baud = 9600;
constexpr std::size_t bytes_per_step = 64;

}  // namespace

RecordedLine::RecordedLine(const link::Uri& uri, DeviceActor& driver, Stamp start)
    : file_(uri.target, std::ios::binary),
      driver_(driver),
      byte_time_(uri.line_rate().value_or(default_baud).time_of(1)),
      raw_(uri.text_of("format") == "raw"),
      chunk_(bytes_per_step) {
  if (!file_) {
    throw std::runtime_error("cannot open the recording " + uri.target + ": " +
                             std::strerror(errno));
  }
  next_ = start + byte_time_ * static_cast<std::int64_t>(bytes_per_step);
  if (!raw_ && capture::is_pcapng(uri.target)) begin_packets(uri, start);
}

void RecordedLine::begin_packets(const link::Uri& uri, Stamp start) {
  packets_ =
      std::make_unique<capture::LineFile>(uri.target, false, std::string(uri.text_of("interface")));
  next_.reset();
  const auto first = packets_->next();
  if (const auto trouble = packets_->trouble(); !trouble.empty()) throw std::runtime_error(trouble);
  if (!first) return;
  read_ = *first;
  before_ = start.time_since_epoch() - read_.time.value_or(Stamp::duration{0});
  next_ = start;
}

/// A time that runs backwards is of a clock that was set: such a read comes at once.
void RecordedLine::act_on_packet(Stamp now) {
  driver_.receive(read_.bytes, now);
  next_.reset();
  const auto following = packets_->next();
  if (!following) return;
  read_ = *following;
  next_ = std::max(now, Stamp{read_.time.value_or(Stamp::duration{0}) + before_});
}

void RecordedLine::act(Stamp now) {
  if (packets_) return act_on_packet(now);
  file_.read(chunk_.data(), static_cast<std::streamsize>(chunk_.size()));
  const auto n = static_cast<std::size_t>(file_.gcount());
  if (n == 0) {
    next_.reset();
    return;
  }
  const wire::Bytes read{reinterpret_cast<const std::uint8_t*>(chunk_.data()), n};
  const wire::Bytes bytes = raw_ ? read : head_.without(read);
  if (!bytes.empty()) driver_.receive(bytes, now);
  next_ = now + byte_time_ * static_cast<std::int64_t>(bytes_per_step);
}

}  // namespace drydock::shell
