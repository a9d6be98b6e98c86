#include "drivers/wire/text_fields.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "drivers/wire/decimal_text.hpp"
#include "drivers/wire/fields.hpp"
#include "drivers/wire/plain_number.hpp"
#include "drivers/wire/text_bytes.hpp"

namespace drydock::wire {
namespace {

template <class T>
std::optional<T> parse(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) {
  const PlainNumber plain = plain_number(text.data(), text.data() + text.size());
  const bool has_sign_of_zero = plain.mantissa == 0 && text.starts_with('-');
  if (plain.is_exact() && plain.end == text.data() + text.size() && !has_sign_of_zero)
    return plain.value();
  const auto value = parse<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parse_integer(std::string_view text) { return parse<int>(text); }

std::size_t TextFields::remaining() const {
  if (ended_) return 0;
  return static_cast<std::size_t>(std::count(rest_.begin(), rest_.end(), separator_)) + 1;
}

std::string_view TextFields::text() {
  if (ended_) return {};
  const std::size_t stop = rest_.find(separator_);
  const std::string_view field = rest_.substr(0, stop);
  ended_ = stop == rest_.npos;
  if (!ended_) rest_.remove_prefix(stop + 1);
  return trimmed(field);
}

std::optional<double> TextFields::number() { return parse_number(text()); }

std::optional<int> TextFields::integer() { return parse_integer(text()); }

std::optional<double> TextFields::angle() {
  const auto value = number();
  return value ? std::optional{radians(*value)} : std::nullopt;
}

void FieldWriter::number(double value, int decimals) {
  std::array<char, decimal_text_size> digits;
  const char* const end = fixed_text(value, decimals, digits.data());
  if (end == nullptr) {
    overflow_ = true;
    return;
  }
  text({digits.data(), end});
}

}  // namespace drydock::wire
