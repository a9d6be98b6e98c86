#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>

#include "drivers/text/json_text.hpp"

namespace drydock::text {

/// Appends JSON values to a text. A double has the fewest digits that read back as the same number.
/// Values that JSON cannot express (NaN, infinity), empty optionals and empty strings become null.
class JsonWriter {
 public:
  explicit JsonWriter(JsonText& out) : out_(out) {}

  /// Accepts a bool, number or string; a struct with `utf8`, whose text is UTF-8; an optional,
  /// array or span of values; a struct with visit_fields.
  template <class T>
  void value(const T& content) {
    out_.end(put(out_.end(), content));
  }

  void open() { out_.append('{'); }
  void close() { out_.end(put_end(out_.end(), '}')); }
  template <class T>
  void field(std::string_view key, const T& content) {
    out_.end(put_field(out_.end(), key, content));
  }
  template <class Struct>
  void fields(const Struct& s) {
    out_.end(put_fields(out_.end(), s));
  }

 private:
  // Each function writes from `at` on and returns the new end. Thus the end stays in a register. As
  // a member it could not: the compiler must assume that a write may change the member.

  char* put(char* at, bool truth) {
    return truth ? put_literal(at, "true") : put_literal(at, "false");
  }
  char* put(char* at, std::string_view text);
  char* put_utf8(char* at, std::string_view text);
  template <class Text>
  requires requires(const Text& text) { std::string_view{text.utf8}; }
  char* put(char* at, const Text& text) { return put_utf8(at, text.utf8); }
  template <std::floating_point T>
  char* put(char* at, T number) {
    return std::isfinite(number) ? write_number(out_.room(at, longest_number), number) : null(at);
  }
  template <std::integral T>
  char* put(char* at, T number) {
    using Wide = std::conditional_t<std::signed_integral<T>, std::int64_t, std::uint64_t>;
    return write_number(out_.room(at, longest_number), Wide{number});  // prints a byte as a number
  }
  template <class T>
  char* put(char* at, const std::optional<T>& maybe) {
    return maybe ? put(at, *maybe) : null(at);
  }
  template <class Range>
  requires(!std::convertible_to<const Range&, std::string_view> && requires(const Range& range) {
    range.begin(), range.end();
  }) char* put(char* at, const Range& range) {
    at = put_character(at, '[');
    for (const auto& item : range) at = put_character(put(at, item), ',');
    return put_end(at, ']');
  }
  template <class Struct>
  requires requires(const Struct& s) {
    visit_fields(s, [](std::string_view, const auto&) {});
  }
  char* put(char* at, const Struct& s) {
    return put_end(put_fields(put_character(at, '{'), s), '}');
  }

  /// Writes a comma behind the field.
  template <class T>
  [[gnu::always_inline]] char* put_field(char* at, std::string_view key, const T& content) {
    at = put_literal(put_literal(put_character(at, '"'), key), "\":");
    return put_character(put(at, content), ',');
  }
  template <class Struct>
  [[gnu::noinline, gnu::flatten]] char* put_fields(char* at, const Struct& s) {
    visit_fields(
        s, [&](std::string_view key, const auto& content) __attribute__((always_inline)) {
          at = this->put_field(at, key, content);  // otherwise clang calls `this` unused
        });
    return at;
  }

  char* put_character(char* at, char c) {
    at = out_.room(at, 1);
    *at = c;
    return at + 1;
  }
  /// Ends an object or array and removes the comma behind its last member.
  char* put_end(char* at, char bracket) {
    at = out_.room(at, 1);
    if (at[-1] == ',') --at;
    *at = bracket;
    return at + 1;
  }
  char* null(char* at) { return put_literal(at, "null"); }

  /// Inlined, so that a literal is copied with a constant length.
  [[gnu::always_inline]] char* put_literal(char* at, std::string_view text) {
    at = out_.room(at, text.size());
    std::memcpy(at, text.data(), text.size());
    return at + text.size();
  }

  JsonText& out_;
};

/// Writes JSON Lines to a file, in blocks.
class JsonLines {
 public:
  explicit JsonLines(std::FILE* file) : file_(file) {}

  /// Writes one line; `fill(JsonWriter&)` gives its fields.
  template <class Fill>
  void line(Fill&& fill) {
    JsonWriter writer(text_);
    writer.open();
    fill(writer);
    writer.close();
    text_.append('\n');
    if (text_.size() >= block) flush();
  }

  /// False if a write has failed, for example to a closed pipe.
  bool flush();

 private:
  static constexpr std::size_t block = 64 * 1024;
  std::FILE* file_;
  JsonText text_{2 * block};
  bool sound_ = true;
};

}  // namespace drydock::text
