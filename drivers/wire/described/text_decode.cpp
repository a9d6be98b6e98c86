#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/described/parts.hpp"
#include "drivers/wire/plain_number.hpp"
#include "drivers/wire/text_fields.hpp"

/// The values of a sentence or a line.
namespace drydock::wire::described {
namespace {

/// Sentences and lines without their line end, and sentences without their checksum.
std::string_view body_of(const Plan& plan, Bytes frame) {
  std::string_view text = as_text(frame);
  while (!text.empty() && (text.back() == '\r' || text.back() == '\n')) text.remove_suffix(1);
  const std::size_t usual = text.size() - std::min(text.size(), 1 + plan.checksum_digits());
  const bool is_usual = usual < text.size() && text.find('*', usual) == usual;
  const std::size_t star = plan.form != Form::sentences ? text.npos
                           : is_usual                   ? usual
                                                        : text.rfind('*');
  return star == text.npos || plan.checksum.size() == 0 ? text : text.substr(0, star);
}

/// Fields of a fixed width have blanks beside the number.
std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  return text;
}

/// One field of a text, and what is behind it.
struct Cut {
  std::string_view field, rest;
  bool ended = false;  ///< the text ended with the field
};

Cut cut(std::string_view text, char end) {
  if (end == ' ')
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  const std::size_t at = end == 0 ? text.npos : text.find(end);
  if (at == text.npos) return {text, {}, true};
  return {text.substr(0, at), text.substr(at + 1), false};
}

std::optional<double> parse_hex_number(const Field& field, std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc{} || stop != text.data() + text.size()) return {};
  if (field.bits > 0 && field.bits < 64)
    return static_cast<double>(value >> field.first_bit & ((1ull << field.bits) - 1));
  const std::size_t unused = 64 - 4 * std::min<std::size_t>(text.size(), 16);
  if (field.type == Type::hex_signed)
    return static_cast<double>(static_cast<std::int64_t>(value << unused) >> unused);
  return static_cast<double>(value);
}

/// The usual number is read here, any other is not worth the code.
std::optional<double> number_in(std::string_view text) {
  const PlainNumber plain = plain_number(text.data(), text.data() + text.size());
  const bool all = plain.end == text.data() + text.size();
  if (all && plain.is_exact() && plain.mantissa != 0) return plain.value();
  return parse_number(text);
}

/// A number whose fraction is behind a comma. One with a point is none.
template <class Read>
std::optional<double> with_comma(std::string_view text, Read&& read) {
  std::array<char, 32> copy{};
  if (text.size() > copy.size() || text.find('.') != text.npos) return {};
  std::ranges::replace_copy(text, copy.begin(), ',', '.');
  return read(std::string_view(copy.data(), text.size()));
}

std::optional<double> value_of(const Field& field, std::string_view text) {
  return field.notation.is_plain() ? number_in(text) : value_in(field.notation, text);
}

std::optional<double> number_of(const Plan& plan, const Field& field, std::string_view text) {
  if (field.type == Type::hex || field.type == Type::hex_signed)
    return parse_hex_number(field, text);
  if (!plan.decimal_comma || field.notation.is_date()) return value_of(field, text);
  return with_comma(text, [&](std::string_view copy) { return value_of(field, copy); });
}

/// False: the text cannot be this field.
bool take(const Plan& plan, const Field& field, std::string_view text, std::size_t i,
          Record& record) {
  Value& value = record.values[i];
  value = {};
  if (field.type == Type::sign) {
    value = {Value::State::text, 0, without_blanks(text)};
    return true;
  }
  if (field.type == Type::text) {
    value = {Value::State::text, 0, text};
    if (field.validity) take_validity(field, value, text, record);
    return true;
  }
  text = without_blanks(text);
  if (text.empty()) {
    if (field.validity) record.valid = false;
    return plan.form == Form::sentences || field.optional;
  }
  const auto number = text.starts_with(field.before)
                          ? number_of(plan, field, text.substr(field.before.size()))
                          : std::nullopt;
  if (!number && plan.form == Form::lines) return false;  // nothing else proves a line
  if (number) take_number(field, *number, value);
  if (!number) value.state = Value::State::malformed;
  if (value.state == Value::State::malformed) record.malformed |= 1u << i;
  if (field.validity) take_validity(field, {Value::State::number, number.value_or(0)}, {}, record);
  return true;
}

/// A text cut into fields at their ends. Of the array only `count` elements are ever written: to
/// clear all of it would cost as much as to read a short sentence.
struct Cuts {
  struct Piece {
    const char* begin;
    std::size_t size;
  };
  std::array<Piece, most_fields> pieces;
  std::size_t count = 0;
  bool ended = false;  ///< nothing is behind them

  std::string_view operator[](std::size_t i) const { return {pieces[i].begin, pieces[i].size}; }
};

/// Each field ends with the separator, the last one with the text.
void cut_at(char separator, std::size_t fields, std::string_view text, Cuts& cuts) {
  const char *begin = text.data(), *const end = begin + text.size();
  cuts.count = 0;
  cuts.ended = true;
  for (const char* at = begin; cuts.count + 1 < fields; ++at) {
    while (at != end && *at != separator) ++at;
    if (at == end) break;
    cuts.pieces[cuts.count++] = {begin, static_cast<std::size_t>(at - begin)};
    begin = at + 1;
  }
  cuts.pieces[cuts.count++] = {begin, static_cast<std::size_t>(end - begin)};
}

void cut_fields(std::span<const Field> fields, std::string_view text, Cuts& cuts) {
  Cut now{{}, text, fields.empty() && text.empty()};
  cuts.count = 0;
  for (const Field& field : fields) {
    if (now.ended) break;
    now = cut(now.rest, field.end);
    cuts.pieces[cuts.count++] = {now.field.data(), now.field.size()};
  }
  if (!fields.empty() && fields.back().end == ' ') now.rest = without_blanks(now.rest);
  const bool whole = cuts.count == fields.size() && !now.ended && now.rest.empty();
  if (fields.empty() || cuts.count < fields.size())
    cuts.ended = now.ended;
  else
    cuts.ended = fields.back().closed ? whole : now.ended || (whole && fields.back().end == ' ');
}

bool is_constant(const Field& field, std::string_view text) {
  const std::string& wanted = field.text;
  if (text.size() != wanted.size()) return field.optional && text.empty();
  if (text.size() == 1) return text[0] == wanted[0];
  return text == wanted;
}

/// False if a constant or the number of fields is another's. Messages of one id differ in these,
/// and a number costs more to read than a constant.
bool may_be(const FlatText& flat, std::span<const Field> fields, const Cuts& cuts) {
  if (!cuts.ended || cuts.count < flat.fewest) return false;
  for (const std::uint8_t i : flat.constants) {
    if (i >= cuts.count) break;
    if (!is_constant(fields[i], cuts[i])) return false;
  }
  return true;
}

bool decode_cuts(const Plan& plan, const FlatText& flat, const Cuts& cuts, Record& record) {
  const auto fields = std::span(plan.fields).subspan(flat.first_field, flat.fields);
  if (!may_be(flat, fields, cuts)) return false;
  record.begin(plan, plan.messages[flat.message]);
  for (const std::uint8_t i : flat.blank) record.values[i] = {};
  for (const std::uint8_t i : flat.read) {
    if (i >= cuts.count)
      record.values[i] = {};
    else if (!take(plan, fields[i], cuts[i], i, record))
      return false;
  }
  join_parts(record);
  apply_signs(record);
  divide(record);
  return true;
}

/// A group that took no part in the line is a field without a value.
bool decode_pattern(const Plan& plan, const Message& message, std::string_view text,
                    Record& record) {
  std::array<std::string_view, most_groups> groups;
  if (!message.line->pattern.match(text, groups)) return false;
  const auto fields = plan.fields_of(message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::string_view found = groups[fields[i].at];
    record.values[i] = {};
    if (fields[i].type == Type::constant || fields[i].type == Type::ignored) continue;
    if (found.empty() && fields[i].validity) record.valid = false;
    if (!found.empty() && !take(plan, fields[i], found, i, record)) return false;
  }
  join_parts(record);
  apply_signs(record);
  divide(record);
  return true;
}

/// The first message of the family whose constants and number of fields are those of the text.
bool decode_family(const Plan& plan, const FlatFamily& family, std::string_view text,
                   Record& record) {
  const auto texts = std::span(plan.texts.texts).subspan(family.first, family.count);
  if (family.by_pattern) {
    const Message& message = plan.messages[texts[0].message];
    record.begin(plan, message);
    return decode_pattern(plan, message, text, record);
  }
  Cuts cuts;
  if (family.separator != 0)
    cut_at(family.separator, texts[0].fields, text, cuts);
  else
    cut_fields(plan.fields_of(plan.messages[texts[0].message]), text, cuts);
  for (const FlatText& flat : texts)
    if (decode_cuts(plan, flat, cuts, record)) return true;
  record.begin(plan, plan.messages[texts.back().message]);
  return false;
}

}  // namespace

Decoded decode_texts(const Plan& plan, Bytes frame, Record& record) {
  const std::string_view body = body_of(plan, frame);
  Decoded result = Decoded::other;
  for (const FlatFamily& family : plan.texts.families) {
    if (!begins(family, frame)) continue;
    const std::string_view text = body.substr(std::min(body.size(), family.head.size()));
    if (decode_family(plan, family, text, record)) return Decoded::message;
    result = Decoded::misfit;
  }
  return result;
}

}  // namespace drydock::wire::described
