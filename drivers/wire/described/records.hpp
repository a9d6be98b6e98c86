#pragma once

#include "drivers/wire/described/binary_bytes.hpp"

/// Binary messages that are made of records (MIP, MTData2, GSOF): each has an identifier, a length
/// and a content, and they come in any order. Or of blocks that a mask names (STDBIN).
namespace drydock::wire::described {

/// Calls `record(bit, content)` for each block that the mask names. Behind those of known size
/// others may stand. False: the last one does not end in the content of the message.
template <class F>
bool for_each_block(const Records& blocks, Bytes content, F&& record) {
  if (content.size() < std::max<std::size_t>(blocks.from, blocks.mask_at + blocks.mask_size))
    return false;
  const auto mask = load(content, blocks.mask_at, blocks.mask_size, blocks.big_endian);
  std::size_t at = blocks.from;
  for (std::size_t bit = 0; bit < blocks.sizes.size(); ++bit) {
    if ((mask >> bit & 1) == 0) continue;
    if (at + blocks.sizes[bit] > content.size()) return false;
    record(static_cast<std::uint16_t>(bit), content.subspan(at, blocks.sizes[bit]));
    at += blocks.sizes[bit];
  }
  return true;
}

/// Calls `record(id, content)` for each record behind the message's header. False: the last one
/// does not end where the content of the message does.
template <class F>
bool for_each_record(const Records& records, Bytes content, F&& record) {
  if (records.are_blocks()) return for_each_block(records, content, std::forward<F>(record));
  if (content.size() < records.from) return false;
  for (Bytes rest = content.subspan(records.from); !rest.empty();) {
    const std::size_t header = records.header();
    if (rest.size() < header) return false;
    const std::size_t size =
        load(rest, records.length_at, records.length_size, records.big_endian) + records.plus;
    if (size < header || size > rest.size()) return false;
    const auto id = load(rest, records.id_at, records.id_size, records.big_endian);
    record(static_cast<std::uint16_t>(id), rest.first(size).subspan(header));
    rest = rest.subspan(size);
  }
  return true;
}

/// Calls `record(id, bytes of its content)` for each record of a message that has fields, in the
/// order of the fields.
template <class F>
void for_each_described_record(std::span<const Field> fields, F&& record) {
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const auto same = [&](const Field& other) { return other.record == fields[i].record; };
    if (!fields[i].record || std::ranges::any_of(fields.first(i), same)) continue;
    std::size_t size = 0;
    for (const Field& field : fields.subspan(i))
      if (same(field)) size = std::max(size, field.at + std::size_t{field.size});
    record(*fields[i].record, size);
  }
}

}  // namespace drydock::wire::described
