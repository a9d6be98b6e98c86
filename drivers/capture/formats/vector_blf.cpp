#include "drivers/capture/formats/vector_blf.hpp"

#include <zlib.h>

#include <algorithm>

#include "drivers/capture/words.hpp"
#include "drivers/wire/bytes.hpp"

namespace drydock::capture {

namespace {

using std::chrono::nanoseconds;
using wire::load_le;

constexpr std::string_view file_sign = "LOGG", object_sign = "LOBJ";
constexpr std::size_t shortest_file_head = 72, longest_file_head = 4096, start_at = 40;
constexpr std::size_t base_head = 16, container_head = 32;
constexpr std::size_t largest_object = 16u << 20;  ///< also when unpacked
constexpr std::size_t best_ratio = 1032;           ///< of deflate: zlib's technical notes

// Types of objects.
constexpr std::uint32_t can_message = 1, can_error = 2, container = 10, can_error_ext = 73,
                        can_message_2 = 86, can_fd_message = 100, can_fd_message_64 = 101;

bool begins_with(Bytes bytes, std::string_view sign) {
  return bytes.size() >= sign.size() && std::equal(sign.begin(), sign.end(), bytes.begin());
}

std::size_t size_of(Bytes object) { return load_le<std::uint32_t>(object, 8); }
std::uint32_t type_of(Bytes object) { return load_le<std::uint32_t>(object, 12); }

/// Programs put up to three bytes behind an object, and do not agree how many.
std::size_t padding(Bytes behind) {
  std::size_t size = 0;
  while (size < 3 && size < behind.size() && !begins_with(behind.subspan(size), object_sign))
    ++size;
  return size;
}

/// Windows' SYSTEMTIME: year, month, day of the week, day, hour, minute, second, millisecond.
nanoseconds start_of(Bytes head) {
  const auto part = [&](std::size_t i) { return load_le<std::uint16_t>(head, start_at + 2 * i); };
  const auto date = date_time(part(0), part(1), part(3));
  if (!date || part(0) < 1970) return nanoseconds{0};
  return *date + std::chrono::hours{part(4)} + std::chrono::minutes{part(5)} +
         std::chrono::seconds{part(6)} + std::chrono::milliseconds{part(7)};
}

/// Since the start of the file. Empty for a time that no file lasts.
std::optional<nanoseconds> time_of(Bytes object) {
  constexpr std::uint32_t in_ten_microseconds = 1;
  const std::uint64_t unit = load_le<std::uint32_t>(object, 16) == in_ten_microseconds ? 10'000 : 1;
  const auto ticks = load_le<std::uint64_t>(object, 24);
  if (ticks > static_cast<std::uint64_t>(latest_time.count()) / unit) return std::nullopt;
  return nanoseconds{static_cast<std::int64_t>(ticks * unit)};
}

}  // namespace

bool VectorBlf::recognises(Bytes head) { return begins_with(head, file_sign); }

Scan VectorBlf::scan(Bytes bytes, bool at_end) {
  if (bytes.size() < base_head) return Scan::need_more();
  if (!head_read_) {
    const std::size_t size = load_le<std::uint32_t>(bytes, 4);
    if (size < shortest_file_head || size > longest_file_head) return Scan::bad_checksum();
    return bytes.size() < size ? Scan::need_more() : Scan::frame(size);
  }
  if (!begins_with(bytes, object_sign) || size_of(bytes) < base_head ||
      size_of(bytes) > largest_object)
    return Scan::bad_checksum();
  const std::size_t size = size_of(bytes), enough = size + 3 + object_sign.size();
  if (bytes.size() < size || (bytes.size() < enough && !at_end)) return Scan::need_more();
  return Scan::frame(size + padding(bytes.subspan(size)));
}

Reading VectorBlf::read(Bytes unit) {
  if (!head_read_) {
    head_read_ = true;
    start_ = start_of(unit);
    return Reading::nothing();
  }
  const Bytes object = unit.first(size_of(unit));
  const bool good = type_of(object) == container ? read_container(object) : read_object(object);
  return {more(), !good};
}

std::optional<Record> VectorBlf::more() {
  if (records_.empty()) return std::nullopt;
  const Record record = records_.front();
  records_.pop_front();
  return record;
}

bool VectorBlf::read_container(Bytes object) {
  constexpr std::uint16_t stored = 0, deflated = 2;
  if (object.size() < container_head) return false;
  const auto method = load_le<std::uint16_t>(object, 16);
  const Bytes packed = object.subspan(container_head);
  if (method == stored) {
    objects_.insert(objects_.end(), packed.begin(), packed.end());
    return read_objects();
  }
  const std::size_t begin = objects_.size();
  uLongf size = load_le<std::uint32_t>(object, 24);
  if (method != deflated || size > largest_object || size > best_ratio * packed.size())
    return false;
  objects_.resize(begin + size);
  const bool whole = ::uncompress(objects_.data() + begin, &size, packed.data(),
                                  static_cast<uLong>(packed.size())) == Z_OK;
  objects_.resize(begin + (whole ? size : 0));
  return read_objects() && whole;
}

/// Reads the objects that are complete. The rest waits for the next container.
bool VectorBlf::read_objects() {
  bool good = true;
  Bytes rest = objects_;
  while (rest.size() >= base_head) {
    if (!begins_with(rest, object_sign) || size_of(rest) < base_head ||
        size_of(rest) > largest_object) {
      good = false;
      rest = rest.subspan(1);
      const auto next =
          std::search(rest.begin(), rest.end(), object_sign.begin(), object_sign.end());
      rest = rest.subspan(static_cast<std::size_t>(next - rest.begin()));
      continue;
    }
    const std::size_t size = size_of(rest);
    if (rest.size() < size) break;
    good &= read_object(rest.first(size));
    rest = rest.subspan(size);
    rest = rest.subspan(padding(rest));
  }
  objects_.erase(objects_.begin(), objects_.end() - static_cast<std::ptrdiff_t>(rest.size()));
  return good;
}

bool VectorBlf::read_object(Bytes object) {
  constexpr std::size_t with_time = 32;
  const std::size_t at = load_le<std::uint16_t>(object, 4);
  const auto type = type_of(object);
  const bool has_frame = type == can_message || type == can_error || type == can_error_ext ||
                         type == can_message_2 || type == can_fd_message ||
                         type == can_fd_message_64;
  if (!has_frame) return true;
  if (at < with_time || object.size() < at + 16) return false;
  switch (type) {
    case can_fd_message: return read_fd(object, at);
    case can_fd_message_64: return read_fd_64(object, at);
    case can_message:
    case can_message_2: return read_classic(object, at);
    default: break;
  }
  const auto error = unspecified_error();
  return take(object, load_le<std::uint16_t>(object, at), error.id, error, error.payload());
}

bool VectorBlf::read_classic(Bytes object, std::size_t at) {
  constexpr std::uint8_t remote = 0x80;
  wire::CanFrame frame;
  frame.remote = (object[at + 2] & remote) != 0;
  frame.size = std::min<std::uint8_t>(object[at + 3], 8);
  return take(object, load_le<std::uint16_t>(object, at), load_le<std::uint32_t>(object, at + 4),
              frame, object.subspan(at + 8));
}

bool VectorBlf::read_fd(Bytes object, std::size_t at) {
  constexpr std::uint8_t remote = 0x80, extended_data_length = 1, bit_rate_switch = 2;
  constexpr std::size_t data = 20;
  if (object.size() < at + data) return false;
  const std::uint8_t flags = object[at + 13];
  wire::CanFrame frame;
  frame.remote = (object[at + 2] & remote) != 0;
  frame.fd = (flags & extended_data_length) != 0;
  frame.bit_rate_switch = frame.fd && (flags & bit_rate_switch) != 0;
  frame.size = frame.remote ? object[at + 3] : object[at + 14];
  return take(object, load_le<std::uint16_t>(object, at), load_le<std::uint32_t>(object, at + 4),
              frame, object.subspan(at + data));
}

bool VectorBlf::read_fd_64(Bytes object, std::size_t at) {
  constexpr std::uint32_t remote = 0x10, extended_data_length = 0x1000, bit_rate_switch = 0x2000;
  constexpr std::size_t data = 40;
  if (object.size() < at + data) return false;
  const auto flags = load_le<std::uint32_t>(object, at + 12);
  wire::CanFrame frame;
  frame.remote = (flags & remote) != 0;
  frame.fd = (flags & extended_data_length) != 0;
  frame.bit_rate_switch = frame.fd && (flags & bit_rate_switch) != 0;
  frame.size = frame.remote ? object[at + 1] : object[at + 2];
  return take(object, object[at], load_le<std::uint32_t>(object, at + 4), frame,
              object.subspan(at + data));
}

/// Keeps the frame if there can be such a one.
bool VectorBlf::take(Bytes object, std::uint16_t channel, std::uint32_t id, wire::CanFrame frame,
                     Bytes data) {
  constexpr std::uint32_t extended = 0x80000000, most_standard = 0x7FF, most_extended = 0x1FFFFFFF;
  const auto time = time_of(object);
  frame.extended = (id & extended) != 0 && !frame.error;
  frame.id = id & ~extended;
  const bool possible = frame.id <= (frame.extended || frame.error ? most_extended : most_standard);
  if (!time || !possible || !(frame.fd ? is_fd_size(frame.size) : frame.size <= 8)) return false;
  if (!frame.remote) {
    if (data.size() < frame.size) return false;
    std::copy_n(data.begin(), frame.size, frame.data.begin());
  }
  auto& interface = interfaces_[channel];
  if (interface.empty()) interface = "can" + std::to_string(std::max<int>(channel, 1) - 1);
  records_.push_back({start_ + *time, interface, frame});
  return true;
}

}  // namespace drydock::capture
