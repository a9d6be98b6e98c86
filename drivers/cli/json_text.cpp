#include "drivers/cli/json_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace drydock::cli {
namespace {

constexpr std::size_t longest_number = 32;

/// `whole` / 10^`decimals`, without zeros at the end.
char* write_decimal(char* at, std::uint64_t whole, int decimals) {
  for (; decimals > 0 && whole % 10 == 0; --decimals) whole /= 10;
  char* const end = std::to_chars(at, at + longest_number, whole).ptr;
  if (decimals == 0) return end;
  const auto digits = end - at;
  const auto before = std::max<std::ptrdiff_t>(digits - decimals, 0);
  const auto zeros = decimals - (digits - before);  // between the point and the first digit
  const auto lead = before > 0 ? before : 1;
  std::memmove(at + lead + 1 + zeros, at + before, static_cast<std::size_t>(digits - before));
  if (before == 0) *at = '0';
  at[lead] = '.';
  std::fill_n(at + lead + 1, zeros, '0');
  return at + lead + 1 + decimals;
}

}  // namespace

void JsonText::grow(std::size_t size) {
  const std::size_t capacity = std::max(2 * capacity_, size_ + size);
  std::unique_ptr<char[]> text(new char[capacity]);
  std::memcpy(text.get(), text_.get(), size_);
  text_ = std::move(text);
  capacity_ = capacity;
}

char* write_number(char* at, double number) {
  // What came over a wire mostly is a whole number of some power of ten. Such a decimal of up to 15
  // digits reads back as `whole` / `unit`, both exact and the quotient rounded once, and no other
  // decimal as short does: if that is the number, these are its fewest digits.
  const double magnitude = std::abs(number);
  for (const auto& [decimals, unit] : {std::pair{0, 1.0}, {3, 1e3}, {7, 1e7}}) {
    const double nearly_whole = magnitude * unit;
    if (nearly_whole >= 1e15) break;
    const auto whole = static_cast<std::int64_t>(nearly_whole + 0.5);
    if (static_cast<double>(whole) / unit != magnitude) continue;
    if (std::signbit(number)) *at++ = '-';
    return write_decimal(at, static_cast<std::uint64_t>(whole), decimals);
  }
  return std::to_chars(at, at + longest_number, number).ptr;
}

char* write_number(char* at, float number) {
  return std::to_chars(at, at + longest_number, number).ptr;
}

}  // namespace drydock::cli
