#include "drivers/wire/dvl/json_reader.hpp"

#include <algorithm>
#include <array>

#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Of each character, whether a word may have it.
constexpr auto words = [] {
  std::array<bool, 256> all{};
  for (unsigned c = 0; c < all.size(); ++c)
    all[c] = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
             c == '-' || c == '+' || c == '.';
  return all;
}();

bool is_of_word(char c) { return words[static_cast<unsigned char>(c)]; }

/// Of a string, as it is: no quote, no backslash, no control character.
bool is_plain(char c) { return static_cast<unsigned char>(c) >= 0x20 && c != '"' && c != '\\'; }

/// The first place from `at` on whose character is none of those, else the end.
template <class IsOne>
std::size_t end_of(std::string_view text, std::size_t at, const IsOne& is_one) {
  while (at < text.size() && is_one(text[at])) ++at;
  return at;
}

/// Goes past digits. False if there was none.
bool take_digits(const char*& at, const char* end) {
  const char* const from = at;
  while (at != end && is_digit(*at)) ++at;
  return at != from;
}

/// The length of the usual number at the front: a minus, digits, digits behind a point, and then
/// nothing that a word may have. 0: it is none, or more of it may come.
std::size_t plain_number_size(std::string_view text) {
  const char *at = text.data(), *const end = at + text.size();
  if (at != end && *at == '-') ++at;
  if (!take_digits(at, end)) return 0;
  if (at != end && *at == '.' && !take_digits(++at, end)) return 0;
  return at == end || is_of_word(*at) ? 0 : static_cast<std::size_t>(at - text.data());
}

bool is_number(std::string_view text) {
  const char *at = text.data(), *const end = at + text.size();
  if (!take_digits(at, end)) return false;
  if (at != end && *at == '.' && !take_digits(++at, end)) return false;
  if (at == end) return true;
  if (*at != 'e' && *at != 'E') return false;
  ++at;
  if (at != end && (*at == '+' || *at == '-')) ++at;
  return take_digits(at, end) && at == end;
}

bool is_scalar(std::string_view word) {
  using namespace std::string_view_literals;
  constexpr std::array names{"true"sv, "false"sv, "null"sv};
  if (std::ranges::find(names, word) != names.end()) return true;
  if (word.starts_with('-')) word.remove_prefix(1);
  constexpr std::array no_values{"NaN"sv, "nan"sv, "Infinity"sv, "inf"sv};
  return is_number(word) || std::ranges::find(no_values, word) != no_values.end();
}

}  // namespace

std::string_view JsonReader::string() {
  expect('"');
  const std::size_t from = at_;
  while (sound()) {
    at_ = end_of(text_, at_, is_plain);
    if (at_ == text_.size() || text_[at_] == '"') break;
    if (text_[at_++] == '\\')
      escape();
    else
      state_ = State::broken;
  }
  if (sound() && at_ == text_.size()) state_ = State::cut;
  if (!sound()) return {};
  return text_.substr(from, at_++ - from);
}

/// Behind a backslash: one letter, or u and four hex digits.
void JsonReader::escape() {
  constexpr std::size_t hex_digits = 4;
  if (at_ == text_.size()) return;  // string() says that it is cut
  const char letter = text_[at_++];
  if (std::string_view{"\"\\/bfnrtu"}.find(letter) == std::string_view::npos)
    state_ = State::broken;
  if (letter != 'u') return;
  for (std::size_t i = 0; i < hex_digits && at_ < text_.size(); ++i, ++at_)
    if (!parse_hex(text_.substr(at_, 1))) state_ = State::broken;
}

std::string_view JsonReader::word() {
  if (peek() == '\0') return {};
  const std::size_t from = at_;
  if (const std::size_t size = plain_number_size(text_.substr(from)); size > 0) {
    at_ += size;
    return text_.substr(from, size);
  }
  at_ = end_of(text_, at_, is_of_word);
  const std::string_view word = text_.substr(from, at_ - from);
  if (at_ == text_.size()) {
    state_ = State::cut;  // more of it may come
  } else if (!is_scalar(word)) {
    state_ = State::broken;
  }
  return sound() ? word : std::string_view{};
}

void JsonReader::skip() {
  switch (peek()) {
    case '{': return object([&](std::string_view) { skip(); });
    case '[': return array([&] { skip(); });
    case '"': string(); return;
    default: word();
  }
}

std::string_view JsonReader::raw() {
  peek();
  const std::size_t from = at_;
  skip();
  return sound() ? text_.substr(from, at_ - from) : std::string_view{};
}

std::optional<double> JsonReader::number() {
  const char first = peek();
  if (first == '{' || first == '[' || first == '"') {
    skip();
    return std::nullopt;
  }
  return parse_number(word());
}

std::optional<bool> JsonReader::boolean() {
  const std::string_view value = raw();
  if (value == "true") return true;
  if (value == "false") return false;
  return std::nullopt;
}

std::string_view JsonReader::text() {
  if (peek() == '"') return string();
  skip();
  return {};
}

}  // namespace drydock::wire
