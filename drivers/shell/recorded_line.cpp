#include "drivers/shell/recorded_line.hpp"

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
}

void RecordedLine::act(Stamp now) {
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
