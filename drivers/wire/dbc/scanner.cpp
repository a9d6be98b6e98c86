#include "drivers/wire/dbc/scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "drivers/wire/dbc/keywords.hpp"

namespace drydock::wire::dbc {

namespace {

constexpr std::string_view blanks_of_a_line = " \t\r\f\v";
constexpr char end_mark_of_dos = '\x1A';

bool is_blank(char c) {
  return blanks_of_a_line.find(c) != std::string_view::npos || c == '\n' || c == end_mark_of_dos ||
         c == '\0';
}

std::string_view without_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(blanks_of_a_line), text.size()));
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
    if (text_.substr(at_, 2) == "\\\"" && !is_last_quote(at_ + 1)) advance();
    content += text_[at_];
  }
  if (at_end()) throw Unreadable{{begin, "the text in quotes has no end"}};
  take(1);
  return content;
}

/// True for a quote with its ';' behind it at the end of a line, before a statement: a backslash in
/// front of it is the last character of a path, and not the sign that the text goes on.
bool Scanner::is_last_quote(std::size_t at) const {
  std::string_view rest = without_blanks(text_.substr(at + 1));
  if (!rest.starts_with(';')) return false;
  rest = without_blanks(rest.substr(1));
  if (!rest.empty() && rest.front() != '\n') return false;
  const Scanner next(rest);
  return next.at_end() || is_keyword(next.next_word());
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

double Scanner::told_number(std::string_view what) {
  constexpr double most = std::numeric_limits<double>::max();
  std::size_t end = at_;
  while (end < text_.size() &&
         (is_of_word(text_[end]) || text_[end] == '.' || text_[end] == '+' || text_[end] == '-'))
    ++end;
  std::string_view text = text_.substr(at_, end - at_);
  const std::size_t size = text.size();
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || fault == std::errc::invalid_argument || stop != text.data() + text.size())
    fail(std::string(what) + " is no number");
  take(size);
  if (fault == std::errc::result_out_of_range) {
    const std::size_t exponent = text.find_first_of("eE");
    const bool small =
        exponent != std::string_view::npos && text.substr(exponent + 1).starts_with('-');
    value = small ? 0 : text.starts_with('-') ? -most : most;
  }
  return std::isnan(value) ? 0 : std::clamp(value, -most, most);
}

std::optional<std::int64_t> Scanner::raw_value(std::string_view what) {
  const std::string_view text = digits(false);
  if (text != digits(true)) {
    const double written = number(what);
    if (std::trunc(written) != written || std::abs(written) >= 0x1p63) return std::nullopt;
    return static_cast<std::int64_t>(written);
  }
  std::uint64_t bits = 0;
  if (!read_whole(text, bits)) return integer(what);
  take(text.size());
  return static_cast<std::int64_t>(bits);
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

bool Scanner::at_statement_end() const {
  return at_end() || next_is(';') || (at_margin() && is_keyword(next_word()));
}

void Scanner::skip_to_statement_end() {
  while (!at_statement_end()) {
    if (next_is('"')) {
      string("a text");
    } else {
      take(1);
    }
  }
}

bool Scanner::next_word_is_alone() const {
  const std::string_view word = next_word();
  const std::string_view rest = without_blanks(text_.substr(at_ + word.size()));
  return !word.empty() && (rest.empty() || rest.front() == '\n');
}

void Scanner::skip_line() {
  while (!at_end() && text_[at_] != '\n') advance();
  skip_blanks();
}

void Scanner::fail(const std::string& why) const { throw Unreadable{{place_, why}}; }

}  // namespace drydock::wire::dbc
