#include <algorithm>
#include <array>
#include <charconv>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/line_end.hpp"
#include "drivers/wire/plain_number.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::described {
namespace {

constexpr bool ends_a_line(std::uint8_t c) { return c == '\r' || c == '\n'; }
constexpr bool is_printable(std::uint8_t c) { return (c >= 0x20 && c <= 0x7E) || c == '\t'; }

/// Above Fh: it is no digit.
constexpr unsigned hex_digit(std::uint8_t c) {
  if (c >= '0' && c <= '9') return c - unsigned{'0'};
  const unsigned letter = c | 0x20u;
  return letter >= 'a' && letter <= 'f' ? letter - 'a' + 10 : 0x100;
}

/// A line may have letters that are not of ASCII, such as a degree sign in any encoding.
constexpr bool is_of_line(std::uint8_t c) { return is_printable(c) || c >= 0x80; }

/// Digits of a checksum behind the '*' of a sentence.
std::size_t checksum_digits(const Plan& plan) { return 2 * plan.checksum.size(); }

Scan at_star(const Plan& plan, Bytes bytes, std::size_t star) {
  const std::size_t digits = checksum_digits(plan);
  if (bytes.size() < star + 1 + digits) return Scan::need_more();
  std::uint32_t sent = 0;
  for (const std::uint8_t c : bytes.subspan(star + 1, digits)) {
    const unsigned digit = hex_digit(c);
    if (digit > 15) return Scan::skip(1);
    sent = sent << 4 | digit;
  }
  const Bytes covered = bytes.first(star).subspan(std::min<std::size_t>(plan.checksum_from, star));
  return sent == plan.checksum.of(covered) ? with_line_end(bytes, star + 1 + digits)
                                           : Scan::bad_checksum();
}

bool begins_message(const Plan& plan, Bytes bytes) {
  if (bytes[0] == '$' || bytes[0] == '!') return true;
  return std::ranges::any_of(plan.texts.families,
                             [&](const FlatFamily& family) { return begins(family, bytes); });
}

/// Sentences and lines without their line end, and sentences without their checksum.
std::string_view body_of(const Plan& plan, Bytes frame) {
  std::string_view text = as_text(frame);
  while (!text.empty() && (text.back() == '\r' || text.back() == '\n')) text.remove_suffix(1);
  const std::size_t usual = text.size() - std::min(text.size(), 1 + checksum_digits(plan));
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

std::optional<double> parse_hex_number(std::string_view text) {
  if (text.starts_with("0x") || text.starts_with("0X")) text.remove_prefix(2);
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, 16);
  if (error != std::errc{} || stop != text.data() + text.size()) return {};
  return static_cast<double>(value);
}

/// The usual number is read here, any other is not worth the code.
std::optional<double> number_in(std::string_view text) {
  const PlainNumber plain = plain_number(text.data(), text.data() + text.size());
  const bool all = plain.end == text.data() + text.size();
  if (all && plain.is_exact() && plain.mantissa != 0) return plain.value();
  return parse_number(text);
}

/// False: the text cannot be this field.
bool take(const Plan& plan, const Field& field, std::string_view text, std::size_t i,
          Record& record) {
  Value& value = record.values[i];
  value = {};
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
  const auto number = field.type == Type::hex ? parse_hex_number(text) : number_in(text);
  if (!number && plan.form == Form::lines) return false;  // nothing else proves a line
  if (number) take_number(field, *number, value);
  if (!number) value.state = Value::State::malformed;
  if (value.state == Value::State::malformed) record.malformed |= 1u << i;
  if (field.validity) take_validity(field, {Value::State::number, number.value_or(0)}, {}, record);
  return true;
}

}  // namespace

Scan scan_sentence(const Plan& plan, Bytes bytes) {
  const bool checked = plan.checksum.size() != 0;
  const std::size_t limit = std::min(bytes.size(), plan.longest);
  for (std::size_t i = 1; i < limit; ++i) {
    const std::uint8_t c = bytes[i];
    if (!plan.texts.stops[c]) continue;
    if (c == '*' && checked) return at_star(plan, bytes, i);
    if (ends_a_line(c) && (!checked || plan.checksum_optional)) return with_line_end(bytes, i);
    if (!is_printable(c)) return Scan::skip(1);
    if (plan.starts[c] && begins_message(plan, bytes.subspan(i))) return Scan::skip(i);
  }
  return limit < bytes.size() || limit == plan.longest ? Scan::skip(1) : Scan::need_more();
}

Scan scan_line(const Plan& plan, Bytes bytes) {
  const std::size_t limit = std::min(bytes.size(), plan.longest);
  std::size_t end = 0;
  while (end < limit && is_of_line(bytes[end])) ++end;
  if (end == limit) return limit == plan.longest ? Scan::skip(1) : Scan::need_more();
  if (!ends_a_line(bytes[end])) return Scan::skip(end);
  Record record;
  if (decode_texts(plan, bytes.first(end), record) == Decoded::message)
    return with_line_end(bytes, end);
  const bool any_start = std::ranges::any_of(plan.messages, &std::string::empty, &Message::head);
  return Scan::skip(any_start ? end : 1);
}

namespace {

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
  divide(record);
  return true;
}

}  // namespace

namespace {

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

namespace {

void write_number(const Field& field, double number, FieldWriter& line) {
  std::array<char, 64> digits;
  const int decimals = field.decimals;
  const bool hex = field.type == Type::hex;
  constexpr double limit = 9e18;  // what 64 bits hold: microseconds since 1970 need 1.8e15
  const double sent = std::clamp(number, -limit, limit);
  const auto written = hex ? std::to_chars(digits.begin(), digits.end(),
                                           static_cast<std::uint64_t>(std::abs(sent)), 16)
                           : std::to_chars(digits.begin(), digits.end(), std::abs(sent),
                                           std::chars_format::fixed, decimals);
  const auto size = static_cast<std::size_t>(written.ptr - digits.begin());
  if (sent < 0) line.text("-");
  for (std::size_t n = size + (sent < 0); n < field.width; ++n) line.text("0");
  line.text({digits.data(), size});
}

/// False: the field has no value, and a line has no way to say so.
bool write_field(const Plan& plan, std::span<const Field> fields, const Field& field,
                 const Readings& readings, FieldWriter& line) {
  if (field.type == Type::ignored || field.type == Type::constant ||
      (field.type == Type::text && !field.validity)) {
    line.text(field.text);
    return true;
  }
  if (field.type == Type::text) {
    line.text(measures_nothing(fields, readings) ? field.validity->bad_text
                                                 : field.validity->good_texts.front());
    return true;
  }
  const auto number = wire_number(fields, field, readings);
  if (number) write_number(field, *number, line);
  return number || plan.form == Form::sentences || field.optional;
}

bool write_fields(const Plan& plan, const Message& message, const Readings& readings,
                  FieldWriter& line) {
  const auto fields = plan.fields_of(message);
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!write_field(plan, fields, fields[i], readings, line)) return false;
    if (i + 1 < fields.size() || fields[i].closed) line.text({&fields[i].end, 1});
  }
  return true;
}

/// A line by a pattern.
bool write_pieces(const Plan& plan, const Message& message, const Readings& readings,
                  FieldWriter& line) {
  const auto fields = plan.fields_of(message);
  for (const WrittenPiece& piece : message.line->written) {
    line.text(piece.text);
    if (piece.field < 0) continue;
    const Field& field = fields[static_cast<std::size_t>(piece.field)];
    if (!write_field(plan, fields, field, readings, line)) return false;
  }
  return true;
}

/// An emulated device of any talker is "integrated instrumentation" (IEC 61162-1).
void write_head(const Message& message, FieldWriter& line) {
  const std::string_view head = message.head;
  if (!message.any_talker) return line.text(head);
  line.text(head.substr(0, 1));
  line.text("II");
  line.text(head.substr(3));
}

void write_checksum(const Plan& plan, FieldWriter& line) {
  if (plan.form != Form::sentences || plan.checksum.size() == 0 || line.size() == 0) return;
  constexpr std::string_view digits = "0123456789ABCDEF";
  const std::uint32_t sum = plan.checksum.of(
      line.written().subspan(std::min<std::size_t>(plan.checksum_from, line.size())));
  line.text("*");
  for (std::size_t left = checksum_digits(plan); left-- > 0;)
    line.text(digits.substr(sum >> (4 * left) & 15, 1));
}

}  // namespace

std::size_t encode_text(const Plan& plan, const Message& message, const Readings& readings,
                        std::span<std::uint8_t> out) {
  FieldWriter line(out);
  write_head(message, line);
  const bool written = message.line ? write_pieces(plan, message, readings, line)
                                    : write_fields(plan, message, readings, line);
  if (!written) return 0;
  write_checksum(plan, line);
  line.text("\r\n");
  return line.size();
}

}  // namespace drydock::wire::described
