#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/text_fields.hpp"

/// A sentence or a line of an emulated device.
namespace drydock::wire::described {
namespace {

/// The digits of a number: hexadecimal ones in capitals, as nearly all sensors write them.
std::string_view digits_of(const Field& field, double magnitude, bool comma,
                           std::span<char, 64> buffer) {
  char* const end = buffer.data() + buffer.size();
  const bool hex = field.type == Type::hex;
  const char* const stop =
      !field.notation.is_plain()
          ? buffer.data() + write_in(field.notation, magnitude, field.decimals, buffer.data(), end)
      : hex ? std::to_chars(buffer.data(), end,
                            static_cast<std::uint64_t>(magnitude) << field.first_bit, 16)
                  .ptr
            : std::to_chars(buffer.data(), end, magnitude, std::chars_format::fixed, field.decimals)
                  .ptr;
  for (char& c : buffer.first(static_cast<std::size_t>(stop - buffer.data()))) {
    if (c >= 'a' && c <= 'f') c = static_cast<char>(c - 'a' + 'A');
    if (c == '.' && comma) c = ',';
  }
  return {buffer.data(), stop};
}

/// Two's complement of `width` digits, which the description must have.
void write_signed_hex(const Field& field, double number, FieldWriter& line) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  const double limit = std::ldexp(1.0, 4 * field.width - 1);
  const double top = std::nextafter(limit, 0);
  const double rounded =
      std::clamp(std::round(within_turn(field, number, -limit, top)), -limit, top);
  const auto raw = static_cast<std::uint64_t>(static_cast<std::int64_t>(rounded));
  for (unsigned left = field.width; left-- > 0;)
    line.text(digits.substr(raw >> (4 * left) & 15, 1));
}

void write_number(const Plan& plan, const Field& field, double number, FieldWriter& line) {
  if (field.type == Type::hex_signed) return write_signed_hex(field, number, line);
  std::array<char, 64> buffer;
  constexpr double limit = 9e18;  // what 64 bits hold: microseconds since 1970 need 1.8e15
  const double sent = std::clamp(number, -limit, limit);
  const auto digits = digits_of(field, std::abs(sent), plan.decimal_comma, buffer);
  const bool is_negative = sent < 0 || (field.has_parts && std::signbit(sent));
  const char sign = is_negative ? '-' : field.sign;
  if (sign != 0) line.text({&sign, 1});
  for (std::size_t n = digits.size() + (sign != 0); n < field.width; ++n) line.text("0");
  line.text(digits);
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
  if (field.type == Type::sign) {
    const auto of = wire_number(fields, fields[field.sign_of], readings);
    if (of) line.text(*of < 0 ? field.minus : field.text);
    return of || plan.form == Form::sentences;
  }
  auto number = wire_number(fields, field, readings);
  if (number && field.signed_apart) number = std::abs(*number);
  if (number) line.text(field.before);
  if (number) write_number(plan, field, *number, line);
  return number || plan.form == Form::sentences || field.optional;
}

bool write_fields(const Plan& plan, const Message& message, const Readings& readings,
                  FieldWriter& line) {
  const auto fields = plan.fields_of(message);
  bool nothing = false;  // stands between two blanks, which are one separator then
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t begun = line.size();
    if (!write_field(plan, fields, fields[i], readings, line)) return false;
    const bool between_blanks = fields[i].end == ' ' || (i > 0 && fields[i - 1].end == ' ');
    nothing |= between_blanks && line.size() == begun;
    if (nothing && (line.size() > begun || !fields[i].optional)) return false;
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
  for (std::size_t left = plan.checksum_digits(); left-- > 0;)
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
