#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "drivers/wire/dbc/database.hpp"

namespace drydock::wire::dbc {

/// What the reader throws inside; it never leaves the reader.
struct Unreadable {
  Remark remark;
};

/// Takes a DBC text apart. Blanks, line ends and `//` comments separate words. Each function takes
/// the next thing or throws Unreadable with its place.
class Scanner {
 public:
  explicit Scanner(std::string_view text);

  bool at_end() const { return at_ == text_.size(); }
  /// Where the next thing stands.
  Place place() const { return place_; }
  /// True if the next thing is the first of its line, without a blank before it.
  bool at_margin() const { return place_.column == 1; }

  /// The next word without taking it; empty if something else comes.
  std::string_view next_word() const;
  bool next_is(char c) const { return !at_end() && text_[at_] == c; }

  std::string_view word(std::string_view what);
  std::string string(std::string_view what);  ///< "..." over any number of lines; \" stays a quote
  double number(std::string_view what);
  /// A number that is only told, as the end of a range. One that no double holds becomes the
  /// nearest double, and `nan` becomes 0.
  double told_number(std::string_view what);
  std::int64_t integer(std::string_view what);
  /// The bits of a raw value: 64 with or without a sign, perhaps written with an exponent. Empty if
  /// the number has a fraction.
  std::optional<std::int64_t> raw_value(std::string_view what);
  std::int64_t bounded(std::string_view what, std::int64_t lowest, std::int64_t highest);
  bool accept(char c);
  void expect(char c);
  /// One character of `allowed`.
  char one_of(std::string_view allowed);

  /// True where a statement is over: at its ';', at the keyword that begins a line, at the end.
  bool at_statement_end() const;
  void skip_to_statement_end();  ///< strings on the way may hold semicolons and keywords
  void skip_line();
  /// True if nothing stands behind the next word on its line.
  bool next_word_is_alone() const;

  [[noreturn]] void fail(const std::string& why) const;

 private:
  void advance();
  void skip_blanks();
  std::string_view take(std::size_t size);
  std::string_view digits(bool with_fraction) const;
  bool is_last_quote(std::size_t at) const;

  std::string_view text_;
  std::size_t at_ = 0;
  Place place_;
};

}  // namespace drydock::wire::dbc
