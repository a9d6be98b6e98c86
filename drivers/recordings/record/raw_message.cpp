#include "drivers/recordings/record/raw_message.hpp"

#include <algorithm>

#include "drivers/wire/bytes.hpp"

namespace drydock::record {

namespace {

constexpr std::int64_t ns_a_second = 1'000'000'000;

/// Positions of the fields, from the first byte of the encapsulation header 00 01 00 00.
enum Offset : std::size_t { sec = 4, nanosec = 8, direction = 12 };
constexpr std::size_t bytes_length = 16, bytes_data = 20;
constexpr std::size_t frame_id = 16, frame_flags = 20, frame_length = 28, frame_data = 32;

void encode_start(std::vector<std::uint8_t>& out, std::size_t size, Stamp at, Direction way) {
  out.assign(size, 0);
  out[1] = 1;
  const std::int64_t ns = at.time_since_epoch().count();
  wire::store_le<std::int32_t>(out, sec, static_cast<std::int32_t>(ns / ns_a_second));
  wire::store_le<std::uint32_t>(out, nanosec, static_cast<std::uint32_t>(ns % ns_a_second));
  out[direction] = static_cast<std::uint8_t>(way);
}

bool starts_well(Bytes cdr, std::size_t size) {
  return cdr.size() >= size && cdr[0] == 0 && cdr[1] == 1 && cdr[direction] <= 1;
}

Stamp stamp_of(Bytes cdr) {
  return measurement::stamp_from_ns(wire::load_le<std::int32_t>(cdr, sec) * ns_a_second +
                                    wire::load_le<std::uint32_t>(cdr, nanosec));
}

}  // namespace

void encode(std::vector<std::uint8_t>& out, const RawBytes& raw) {
  encode_start(out, bytes_data + raw.data.size(), raw.at, raw.direction);
  wire::store_le<std::uint32_t>(out, bytes_length, static_cast<std::uint32_t>(raw.data.size()));
  std::ranges::copy(raw.data, out.begin() + bytes_data);
}

void encode(std::vector<std::uint8_t>& out, const RawFrame& raw) {
  const auto& frame = raw.frame;
  encode_start(out, frame_data + frame.size, raw.at, raw.direction);
  wire::store_le<std::uint32_t>(out, frame_id, frame.id);
  const bool flags[] = {frame.extended, frame.remote, frame.error, frame.fd, frame.bit_rate_switch};
  std::ranges::copy(flags, out.begin() + frame_flags);
  wire::store_le<std::uint32_t>(out, frame_length, frame.size);
  std::ranges::copy(frame.payload(), out.begin() + frame_data);
}

std::optional<RawBytes> decode_bytes(Bytes cdr) {
  if (!starts_well(cdr, bytes_data)) return {};
  const auto length = wire::load_le<std::uint32_t>(cdr, bytes_length);
  if (length != cdr.size() - bytes_data) return {};
  return RawBytes{stamp_of(cdr), static_cast<Direction>(cdr[direction]), cdr.subspan(bytes_data)};
}

std::optional<RawFrame> decode_frame(Bytes cdr) {
  if (!starts_well(cdr, frame_data)) return {};
  RawFrame raw{stamp_of(cdr), static_cast<Direction>(cdr[direction]), {}};
  auto& frame = raw.frame;
  const auto length = wire::load_le<std::uint32_t>(cdr, frame_length);
  if (length != cdr.size() - frame_data || length > frame.data.size()) return {};
  frame.id = wire::load_le<std::uint32_t>(cdr, frame_id);
  bool* const flags[] = {&frame.extended, &frame.remote, &frame.error, &frame.fd,
                         &frame.bit_rate_switch};
  for (std::size_t i = 0; i < std::size(flags); ++i) *flags[i] = cdr[frame_flags + i] != 0;
  frame.size = static_cast<std::uint8_t>(length);
  std::ranges::copy(cdr.subspan(frame_data), frame.data.begin());
  return raw;
}

}  // namespace drydock::record
