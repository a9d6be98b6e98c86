#include "drivers/wire/dvl/ad2cp_frame.hpp"

#include <cstring>

#include "drivers/wire/bytes.hpp"

namespace drydock::wire::ad2cp {
namespace {

constexpr std::uint8_t record_sync = 0xA5;
constexpr std::size_t long_header = 12;
constexpr std::uint16_t sum_start = 0xB58C;

std::size_t bytes_before_sync(Bytes bytes) {
  const void* const at = std::memchr(bytes.data(), record_sync, bytes.size());
  return at ? static_cast<std::size_t>(static_cast<const std::uint8_t*>(at) - bytes.data())
            : bytes.size();
}

/// The two sums are the header's last words; the header's own does not cover itself.
bool is_sound_header(Bytes header) {
  const std::size_t covered = header.size() - 2;
  return word_sum(header.first(covered)) == load_le<std::uint16_t>(header, covered);
}

bool is_sound_data(Bytes frame, const Header& header) {
  const auto said = load_le<std::uint16_t>(frame, header.size - 4);
  return word_sum(frame.subspan(header.size)) == said;
}

}  // namespace

std::uint16_t word_sum(Bytes bytes) {
  std::uint16_t sum = sum_start;
  for (; bytes.size() >= 2; bytes = bytes.subspan(2))
    sum = static_cast<std::uint16_t>(sum + load_le<std::uint16_t>(bytes, 0));
  return bytes.empty() ? sum : static_cast<std::uint16_t>(sum + (bytes[0] << 8));
}

Header read_header(Bytes frame) {
  Header header{frame[1], frame[2], frame[3], 0};
  header.data_size = header.size == long_header ? load_le<std::uint32_t>(frame, 4)
                                                : load_le<std::uint16_t>(frame, 4);
  return header;
}

Scan scan_record(Bytes bytes, std::size_t longest) {
  if (const std::size_t noise = bytes_before_sync(bytes)) return Scan::skip(noise);
  if (bytes.size() < 2) return Scan::need_more();
  if (bytes[1] != short_header && bytes[1] != long_header) return Scan::skip(1);
  if (bytes.size() < bytes[1]) return Scan::need_more();
  if (!is_sound_header(bytes.first(bytes[1]))) return Scan::bad_checksum();
  const Header header = read_header(bytes);
  if (header.data_size > longest - header.size) return Scan::skip(1);
  const std::size_t size = header.size + header.data_size;
  if (bytes.size() < size) return Scan::need_more(size);
  return is_sound_data(bytes.first(size), header) ? Scan::frame(size) : Scan::bad_checksum();
}

std::size_t close_record(std::uint8_t id, std::uint8_t family, std::size_t data_size,
                         std::span<std::uint8_t> out) {
  out[0] = record_sync;
  out[1] = short_header;
  out[2] = id;
  out[3] = family;
  store_le<std::uint16_t>(out, 4, static_cast<std::uint16_t>(data_size));
  store_le<std::uint16_t>(out, 6, word_sum(out.subspan(short_header, data_size)));
  store_le<std::uint16_t>(out, 8, word_sum(out.first(short_header - 2)));
  return short_header + data_size;
}

}  // namespace drydock::wire::ad2cp
