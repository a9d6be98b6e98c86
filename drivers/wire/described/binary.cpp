#include <algorithm>
#include <cmath>

#include "drivers/wire/described/binary_bytes.hpp"
#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/described/parts.hpp"
#include "drivers/wire/described/records.hpp"

namespace drydock::wire::described {
namespace {

/// Two decimal digits of each byte.
std::optional<double> decimal_digits(std::uint64_t raw, std::size_t size) {
  double value = 0;
  for (std::size_t digit = 2 * size; digit-- > 0;) {
    const unsigned one = raw >> (4 * digit) & 15;
    if (one > 9) return {};
    value = value * 10 + one;
  }
  return value;
}

/// Seven bits of each byte, in the order of the bytes of `raw`.
std::uint64_t packed_septets(std::uint64_t raw, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i) value |= (raw >> (8 * i) & 0x7F) << (7 * i);
  return value;
}

std::optional<double> number_of(const Field& field, Bytes frame) {
  const std::uint64_t raw = load(field, frame);
  if (field.type == Type::bcd) return decimal_digits(raw, field.size);
  if (field.type == Type::septet) return static_cast<double>(packed_septets(raw, field.size));
  if (field.type == Type::real && field.size == 4)
    return std::bit_cast<float>(static_cast<std::uint32_t>(raw));
  if (field.type == Type::real) return std::bit_cast<double>(raw);
  const unsigned bits = bits_of(field);
  const std::uint64_t part = raw >> field.first_bit & mask_of(bits);
  if (field.type == Type::signed_integer && bits > 0 && bits < 64 && (part >> (bits - 1)) != 0)
    return static_cast<double>(static_cast<std::int64_t>(part | ~mask_of(bits)));
  if (field.type == Type::signed_integer)
    return static_cast<double>(static_cast<std::int64_t>(part));
  return static_cast<double>(part);
}

/// Reads field `i` of these bytes, in which its place counts. False: they are too short for it, or
/// have another constant.
bool take(const Field& field, Bytes bytes, std::size_t i, Record& record) {
  if (field.at + std::size_t{field.size} > bytes.size()) return false;
  if (field.type == Type::constant) return has_constant(field, bytes);
  Value& value = record.values[i];
  const auto number = number_of(field, bytes);
  if (field.type == Type::real && number && std::isnan(*number)) return true;  // it says: no value
  if (number && field.validity) take_validity(field, {Value::State::number, *number}, {}, record);
  if (number) take_number(field, *number, value);
  if (!number) value.state = Value::State::malformed;
  if (value.state == Value::State::malformed) record.malformed |= 1u << i;
  return true;
}

/// The fields of each record that came. False: a record is longer than the frame, or too short.
bool take_records(const Plan& plan, const Message& message, Bytes content, Record& record) {
  const auto fields = plan.fields_of(message);
  bool fit = true;
  const bool whole = for_each_record(*message.records, content, [&](std::uint16_t id, Bytes of) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (fields[i].record != id) continue;
      fit = fit && take(fields[i], of, i, record);
      record.present |= 1u << i;
    }
  });
  return fit && whole;
}

}  // namespace

bool decode_binary(const Plan& plan, const Message& message, Bytes frame, Record& record) {
  if (frame.size() < plan.least() || !has_length(message.length, frame)) return false;
  const auto fields = plan.fields_of(message);
  const Bytes content = frame.first(frame.size() - plan.tail());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    record.values[i] = {};
    if (!fields[i].record && !take(fields[i], content, i, record)) return false;
  }
  if (message.records && !take_records(plan, message, content, record)) return false;
  join_parts(record);
  divide(record);
  return true;
}

namespace {

std::uint64_t integer_of(const Field& field, double number) {
  const unsigned bits = bits_of(field);
  const bool is_signed = field.type == Type::signed_integer;
  const double high = std::ldexp(1.0, static_cast<int>(is_signed ? bits - 1 : bits));
  const double low = is_signed ? -high : 0;
  const double top = bits > 53 ? std::nextafter(high, 0) : high - 1;  // doubles have 53 bits
  const double rounded = std::clamp(std::round(within_turn(field, number, low, top)), low, top);
  if (rounded < 0) return static_cast<std::uint64_t>(static_cast<std::int64_t>(rounded));
  return static_cast<std::uint64_t>(rounded);
}

std::uint64_t spread_septets(double number, std::size_t size) {
  const double most = std::ldexp(1.0, static_cast<int>(7 * size)) - 1;  // at most 56 bits
  const auto value = static_cast<std::uint64_t>(std::clamp(std::round(number), 0.0, most));
  std::uint64_t spread = 0;
  for (std::size_t i = 0; i < size; ++i) spread |= (value >> (7 * i) & 0x7F) << (8 * i);
  return spread;
}

std::uint64_t packed_digits(double number, std::size_t size) {
  std::uint64_t packed = 0;
  double left = std::max(0.0, std::round(number));
  for (std::size_t digit = 0; digit < 2 * size; ++digit) {
    packed |= static_cast<std::uint64_t>(std::fmod(left, 10)) << (4 * digit);
    left = std::floor(left / 10);
  }
  return packed;
}

void put(const Field& field, double number, std::span<std::uint8_t> out) {
  std::uint64_t raw = 0;
  if (field.type == Type::real && field.size == 4) {
    raw = std::bit_cast<std::uint32_t>(static_cast<float>(number));
  } else if (field.type == Type::real) {
    raw = std::bit_cast<std::uint64_t>(number);
  } else if (field.type == Type::bcd) {
    raw = packed_digits(number, field.size);
  } else if (field.type == Type::septet) {
    raw = spread_septets(number, field.size);
  } else {
    const std::uint64_t mask = mask_of(bits_of(field)) << field.first_bit;
    raw = load(field, out) & ~mask;
    raw |= integer_of(field, number) << field.first_bit & mask;
  }
  store(field, raw, out);
}

}  // namespace

namespace {

/// Writes the checksums of a whole message. That of the header is first, unless it covers the
/// other.
void put_checksums(const Plan& plan, const Message& message, std::span<std::uint8_t> whole) {
  const std::size_t content = whole.size() - plan.tail();
  const std::size_t at = plan.checksum_at.value_or(static_cast<std::uint16_t>(content));
  const auto put_header = [&] {
    const HeaderChecksum& header = *plan.header;
    const Bytes covered = Bytes(whole).first(header.to).subspan(header.from);
    store(whole, header.at, header.checksum.size(), plan.checksum_big_endian,
          header.checksum.of(covered));
  };
  const bool header_is_last = plan.header && at >= plan.header->from && at < plan.header->to;
  if (plan.header && !header_is_last) put_header();
  if (plan.checksum.size() != 0)
    store(whole, at, plan.checksum.size(), plan.checksum_big_endian,
          plan.checksum.of(Bytes(whole).first(content).subspan(plan.checksum_from),
                           bytes_of(message.extra)));
  if (header_is_last) put_header();
}

/// False: the field has no way to say that there is no value.
bool put_field(std::span<const Field> fields, const Field& field, const Readings& readings,
               std::span<std::uint8_t> out) {
  const auto number = wire_number(fields, field, readings);
  const bool real = field.type == Type::real;
  if (!number && !real && !says_nothing_holds(fields, readings)) return false;
  if (!number && !real && field.idle == 0) return true;  // another field may have a value there
  put(field, number.value_or(real ? std::nan("") : field.idle), out);
  return true;
}

/// The bits of the blocks that have fields.
std::uint64_t mask_of_blocks(std::span<const Field> fields) {
  std::uint64_t mask = 0;
  for (const Field& field : fields)
    if (field.record) mask |= std::uint64_t{1} << *field.record;
  return mask;
}

std::size_t bytes_of_blocks(const Records& blocks, std::span<const Field> fields) {
  std::size_t bytes = 0;
  const std::uint64_t mask = mask_of_blocks(fields);
  for (std::size_t bit = 0; bit < blocks.sizes.size(); ++bit)
    if ((mask >> bit & 1) != 0) bytes += blocks.sizes[bit];
  return bytes;
}

std::size_t bytes_of_records(const Records& records, std::span<const Field> fields) {
  if (records.are_blocks()) return bytes_of_blocks(records, fields);
  std::size_t bytes = 0;
  for_each_described_record(
      fields, [&](std::uint16_t, std::size_t size) { bytes += records.header() + size; });
  return bytes;
}

bool put_records(const Records& records, std::span<const Field> fields, const Readings& readings,
                 std::span<std::uint8_t> out) {
  bool all = true;
  for_each_described_record(fields, [&](std::uint16_t id, std::size_t size) {
    const std::size_t whole = records.header() + size;
    store(out, records.id_at, records.id_size, records.big_endian, id);
    store(out, records.length_at, records.length_size, records.big_endian, whole - records.plus);
    for (const Field& field : fields)
      if (field.record == id)
        all &= put_field(fields, field, readings, out.subspan(records.header()));
    out = out.subspan(whole);
  });
  return all;
}

bool put_blocks(const Records& blocks, std::span<const Field> fields, const Readings& readings,
                std::span<std::uint8_t> out) {
  const std::uint64_t mask = mask_of_blocks(fields);
  store(out, blocks.mask_at, blocks.mask_size, blocks.big_endian, mask);
  std::size_t at = blocks.from;
  for (std::size_t bit = 0; bit < blocks.sizes.size(); ++bit) {
    if ((mask >> bit & 1) == 0) continue;
    for (const Field& field : fields)
      if (field.record == bit && !put_field(fields, field, readings, out.subspan(at))) return false;
    at += blocks.sizes[bit];
  }
  return true;
}

/// Bytes of a message in front of its records and its tail.
std::size_t header_size(const Plan& plan, const Message& message) {
  std::size_t size = std::max({message.head.size(), plan.least() - plan.tail(),
                               message.length.at + std::size_t{message.length.size}});
  for (const Field& field : plan.fields_of(message))
    if (!field.record) size = std::max(size, field.at + std::size_t{field.size});
  return message.records ? std::max<std::size_t>(size, message.records->from) : size;
}

std::size_t encode_whole(const Plan& plan, const Message& message, const Readings& readings,
                         std::span<std::uint8_t> out) {
  const auto fields = plan.fields_of(message);
  const std::size_t header = header_size(plan, message), tail = plan.tail();
  const std::size_t content =
      header + (message.records ? bytes_of_records(*message.records, fields) : 0);
  const bool fixed = message.length.size == 0 && !message.length.is_any();
  const std::size_t size = fixed ? message.length.fixed : content + tail;
  if (size > out.size() || size < content + tail) return 0;
  std::fill_n(out.begin(), size, std::uint8_t{0});
  std::ranges::copy(message.head, out.begin());
  const Length& length = message.length;
  if (length.size != 0) store(out, length.at, length.size, length.big_endian, size - length.plus);
  for (const Field& field : fields)
    if (!field.record && !put_field(fields, field, readings, out)) return 0;
  const auto& records = message.records;
  if (records && records->are_blocks() && !put_blocks(*records, fields, readings, out)) return 0;
  if (records && !records->are_blocks() &&
      !put_records(*records, fields, readings, out.subspan(header)))
    return 0;
  put_checksums(plan, message, out.first(size));
  std::ranges::copy(plan.end, out.begin() + static_cast<std::ptrdiff_t>(size - plan.end.size()));
  return size;
}

}  // namespace

std::size_t encode_binary(const Plan& plan, const Message& message, const Readings& readings,
                          std::span<std::uint8_t> out) {
  if (plan.stuffing == Stuffing::none) return encode_whole(plan, message, readings, out);
  Packet packet(longest_frame, boost::container::default_init);
  packet.resize(encode_whole(plan, message, readings, packet));
  return packet.empty() ? 0 : stuff(plan.stuffing, packet, out);
}

}  // namespace drydock::wire::described
