#include "drivers/wire/dbc/scanner.hpp"

#include <charconv>
#include <cmath>

namespace drydock::wire::dbc {

namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_of_word(char c) {
  return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool continues_character(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

template <class T>
bool read_whole(std::string_view digits, T& number) {
  if (!digits.empty() && digits.front() == '+') digits.remove_prefix(1);
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return error == std::errc{} && end == digits.data() + digits.size();
}

}  // namespace

Scanner::Scanner(std::string_view text) : text_(text) { skip_blanks(); }

void Scanner::advance() {
  const char c = text_[at_++];
  if (c == '\n') {
    ++place_.line;
    place_.column = 1;
  } else if (at_ == text_.size() || !continues_character(text_[at_])) {
    ++place_.column;
  }
}

void Scanner::skip_blanks() {
  while (!at_end()) {
    if (text_.substr(at_, 2) == "//") {
      while (!at_end() && text_[at_] != '\n') advance();
    } else if (is_blank(text_[at_])) {
      advance();
    } else {
      return;
    }
  }
}

std::string_view Scanner::take(std::size_t size) {
  const std::string_view taken = text_.substr(at_, size);
  for (std::size_t i = 0; i < size; ++i) advance();
  skip_blanks();
  return taken;
}

std::string_view Scanner::next_word() const {
  std::size_t end = at_;
  while (end < text_.size() && is_of_word(text_[end])) ++end;
  return text_.substr(at_, end - at_);
}

std::string_view Scanner::word(std::string_view what) {
  const std::string_view next = next_word();
  if (next.empty()) fail(std::string(what) + " is missing");
  return take(next.size());
}

std::string Scanner::string(std::string_view what) {
  if (!next_is('"')) fail(std::string(what) + " is missing, a text in quotes");
  const Place begin = place_;
  std::string content;
  for (advance(); !at_end() && text_[at_] != '"'; advance()) {
    if (text_.substr(at_, 2) == "\\\"") advance();
    content += text_[at_];
  }
  if (at_end()) throw Unreadable{{begin, "the text in quotes has no end"}};
  take(1);
  return content;
}

std::string_view Scanner::digits(bool with_fraction) const {
  std::size_t end = at_;
  const auto sign = [&] { end += end < text_.size() && (text_[end] == '+' || text_[end] == '-'); };
  const auto run = [&] {
    while (end < text_.size() && is_digit(text_[end])) ++end;
  };
  sign();
  run();
  if (with_fraction) {
    if (end < text_.size() && text_[end] == '.') ++end, run();
    if (end < text_.size() && (text_[end] == 'e' || text_[end] == 'E')) ++end, sign(), run();
  }
  return text_.substr(at_, end - at_);
}

double Scanner::number(std::string_view what) {
  const std::string_view text = digits(true);
  double value = 0;
  if (!read_whole(text, value) || !std::isfinite(value)) fail(std::string(what) + " is no number");
  take(text.size());
  return value;
}

std::int64_t Scanner::integer(std::string_view what) {
  const std::string_view text = digits(false);
  std::int64_t value = 0;
  if (!read_whole(text, value)) fail(std::string(what) + " is no integer of 64 bits");
  take(text.size());
  return value;
}

std::int64_t Scanner::bounded(std::string_view what, std::int64_t lowest, std::int64_t highest) {
  const Place at = place_;
  const std::int64_t value = integer(what);
  if (value >= lowest && value <= highest) return value;
  throw Unreadable{{at, std::string(what) + " is beyond " + std::to_string(lowest) + " to " +
                            std::to_string(highest)}};
}

bool Scanner::accept(char c) {
  if (!next_is(c)) return false;
  take(1);
  return true;
}

void Scanner::expect(char c) {
  if (!accept(c)) fail(std::string("'") + c + "' is missing");
}

char Scanner::one_of(std::string_view allowed) {
  if (at_end() || allowed.find(text_[at_]) == std::string_view::npos)
    fail("one of \"" + std::string(allowed) + "\" is missing");
  return take(1).front();
}

void Scanner::skip_to_semicolon() {
  while (!at_end() && !next_is(';')) {
    if (next_is('"')) {
      string("a text");
    } else {
      take(1);
    }
  }
  accept(';');
}

void Scanner::skip_line() {
  while (!at_end() && text_[at_] != '\n') advance();
  skip_blanks();
}

void Scanner::fail(const std::string& why) const { throw Unreadable{{place_, why}}; }

}  // namespace drydock::wire::dbc
