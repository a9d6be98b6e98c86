#include "drivers/recordings/mcap/salvage.hpp"

#include <algorithm>

#include "drivers/recordings/mcap/decoder.hpp"
#include "drivers/recordings/mcap/encoder.hpp"

namespace drydock::mcap {

namespace {

constexpr std::size_t scan_block = 1u << 20;
constexpr std::size_t chunk_head = record_head + 3 * sizeof(std::uint64_t) + sizeof(std::uint32_t);
/// Of the largest head that is looked at: with the name and the length of the packed records.
constexpr std::size_t longest_head = chunk_head + 4 + 4 + 8;

Buffer read_at(std::istream& file, std::uint64_t from, std::uint64_t size) {
  Buffer bytes(static_cast<std::size_t>(size));
  file.clear();
  file.seekg(static_cast<std::streamoff>(from));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(file.gcount()));
  file.clear();
  return bytes;
}

/// `left`: bytes from here to the end of the file.
bool is_chunk_head(Bytes bytes, std::uint64_t left) {
  Decoder fields(bytes);
  if (fields.number<std::uint8_t>() != static_cast<std::uint8_t>(Opcode::chunk)) return false;
  const auto length = fields.number<std::uint64_t>();
  const auto first = fields.number<std::uint64_t>(), last = fields.number<std::uint64_t>();
  fields.number<std::uint64_t>();  // unpacked size and checksum
  fields.number<std::uint32_t>();
  const auto compression = fields.text();
  const auto packed = fields.number<std::uint64_t>();
  const std::uint64_t inner = longest_head - record_head - 4 + compression.size();
  return fields.good() && left > record_head && length <= left - record_head && first <= last &&
         (compression.empty() || compression == "zstd") && packed == length - inner;
}

}  // namespace

std::optional<std::uint64_t> find_chunk(std::istream& file, std::uint64_t from,
                                        std::uint64_t size) {
  while (from < size) {
    const Buffer bytes = read_at(file, from, std::min<std::uint64_t>(scan_block, size - from));
    const bool last = from + bytes.size() >= size || bytes.size() < longest_head;
    const std::size_t heads = last ? bytes.size() : bytes.size() - longest_head + 1;
    for (std::size_t i = 0; i < heads; ++i) {
      if (bytes[i] != static_cast<std::uint8_t>(Opcode::chunk)) continue;
      const auto rest = Bytes(bytes).subspan(i);
      if (is_chunk_head(rest.first(std::min(rest.size(), longest_head)), size - from - i))
        return from + i;
    }
    if (last) return {};
    from += heads;
  }
  return {};
}

namespace {

/// The attachment that a record of the summary points at; empty: it is damaged.
std::optional<Record> attachment_at(std::istream& file, Bytes index) {
  constexpr std::uint64_t most = 64u << 20;
  Decoder fields(index);
  const auto offset = fields.number<std::uint64_t>(), length = fields.number<std::uint64_t>();
  if (!fields.good() || length < record_head || length > most) return {};
  const Buffer bytes = read_at(file, offset, length);
  if (bytes.size() != length || bytes[0] != static_cast<std::uint8_t>(Opcode::attachment))
    return {};
  return decode(Opcode::attachment, Bytes(bytes).subspan(record_head));
}

}  // namespace

std::vector<Record> definitions(std::istream& file, std::uint64_t size) {
  constexpr std::size_t footer = record_head + 2 * sizeof(std::uint64_t) + sizeof(std::uint32_t);
  constexpr std::uint64_t most = 64u << 20;
  if (size < footer + magic.size()) return {};
  const std::uint64_t footer_at = size - footer - magic.size();
  const Buffer end = read_at(file, footer_at, footer + magic.size());
  if (end.size() != footer + magic.size() ||
      !std::equal(magic.begin(), magic.end(), end.end() - magic.size()))
    return {};
  Decoder fields(end);
  if (fields.number<std::uint8_t>() != static_cast<std::uint8_t>(Opcode::footer)) return {};
  fields.number<std::uint64_t>();  // the footer's length
  const auto begin = fields.number<std::uint64_t>();
  fields.number<std::uint64_t>();  // where the offsets begin
  const auto crc = fields.number<std::uint32_t>();
  if (begin == 0 || begin > footer_at || footer_at - begin > most) return {};
  const std::uint64_t covered = footer_at - begin + footer - sizeof crc;
  const Buffer summary = read_at(file, begin, covered);
  if (summary.size() != covered || (crc != 0 && crc32(summary) != crc)) return {};

  std::vector<Record> found;
  Decoder records(Bytes(summary).first(static_cast<std::size_t>(footer_at - begin)));
  while (records.good()) {
    const auto opcode = static_cast<Opcode>(records.number<std::uint8_t>());
    const Bytes content = records.bytes(records.number<std::uint64_t>());
    if (!records.good()) continue;
    std::optional<Record> record;
    if (opcode == Opcode::schema || opcode == Opcode::channel) record = decode(opcode, content);
    if (opcode == Opcode::attachment_index) record = attachment_at(file, content);
    if (record) found.push_back(std::move(*record));
  }
  return found;
}

}  // namespace drydock::mcap
