#include "drivers/wire/dvl/json_reader.hpp"

#include <algorithm>
#include <array>

#include "drivers/wire/hex.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

constexpr bool is_of_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '+' ||
         c == '.';
}

/// Removes digits from the front. False if there was none.
bool take_digits(std::string_view& rest) {
  const std::size_t before = rest.size();
  while (!rest.empty() && is_digit(rest.front())) rest.remove_prefix(1);
  return rest.size() < before;
}

bool take(std::string_view& rest, std::string_view any_of) {
  if (rest.empty() || any_of.find(rest.front()) == any_of.npos) return false;
  rest.remove_prefix(1);
  return true;
}

bool is_number(std::string_view rest) {
  if (!take_digits(rest)) return false;
  if (take(rest, ".") && !take_digits(rest)) return false;
  if (!take(rest, "eE")) return rest.empty();
  take(rest, "+-");
  return take_digits(rest) && rest.empty();
}

bool is_scalar(std::string_view word) {
  using namespace std::string_view_literals;
  if (word == "true"sv || word == "false"sv || word == "null"sv) return true;
  take(word, "-");
  constexpr std::array no_values{"NaN"sv, "nan"sv, "Infinity"sv, "inf"sv};
  return is_number(word) || std::ranges::find(no_values, word) != no_values.end();
}

}  // namespace

char JsonReader::peek() {
  while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  if (sound() && at_ == text_.size()) state_ = State::cut;
  return sound() ? text_[at_] : '\0';
}

bool JsonReader::accept(char wanted) {
  if (peek() != wanted) return false;
  ++at_;
  return true;
}

void JsonReader::expect(char wanted) {
  if (!accept(wanted) && sound()) state_ = State::broken;
}

std::string_view JsonReader::string() {
  expect('"');
  const std::size_t from = at_;
  while (sound() && at_ < text_.size() && text_[at_] != '"') {
    const auto c = static_cast<unsigned char>(text_[at_++]);
    if (c < 0x20) state_ = State::broken;
    if (c == '\\') escape();
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
  while (at_ < text_.size() && is_of_word(text_[at_])) ++at_;
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
