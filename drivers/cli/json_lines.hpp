#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <optional>
#include <string_view>

#include "drivers/cli/json_text.hpp"

namespace drydock::cli {

/// Appends JSON values to a text. Doubles have the fewest digits that read back as the same number;
/// what JSON has no number for (NaN, infinity), empty optionals and empty strings are null.
class JsonWriter {
 public:
  explicit JsonWriter(JsonText& out) : out_(out) {}

  void value(bool truth) { truth ? out_.append("true") : out_.append("false"); }
  void value(std::string_view text);
  template <std::floating_point T>
  void value(T number) {
    if (!std::isfinite(number)) return null();
    out_.end(write_number(out_.room(longest_number), number));
  }
  template <std::integral T>
  void value(T number) {
    char* const at = out_.room(longest_number);
    out_.end(std::to_chars(at, at + longest_number, +number).ptr);  // a byte is a number too
  }
  template <class T>
  void value(const std::optional<T>& maybe) {
    if (!maybe) return null();
    value(*maybe);
  }
  /// Arrays and spans of values or of structs with visit_fields.
  template <class Range>
  requires requires(const Range& range) { range.begin(), range.end(); }
  void value(const Range& range) {
    out_.append('[');
    bool first = true;
    for (const auto& item : range) {
      if (!first) out_.append(',');
      first = false;
      value(item);
    }
    out_.append(']');
  }
  /// A struct: the object of its fields.
  template <class Struct>
  requires requires(const Struct& s) {
    visit_fields(s, [](std::string_view, const auto&) {});
  }
  void value(const Struct& s) {
    open();
    fields(s);
    close();
  }

  void open() {
    out_.append('{');
    first_ = true;
  }
  void close() {
    out_.append('}');
    first_ = false;
  }
  /// Inlined, so that a literal key is written by moves of its known length.
  template <class T>
  [[gnu::always_inline]] void field(std::string_view key, const T& content) {
    char* at = out_.room(key.size() + 4);
    if (!first_) *at++ = ',';
    *at++ = '"';
    std::memcpy(at, key.data(), key.size());
    at += key.size();
    *at++ = '"';
    *at++ = ':';
    out_.end(at);
    first_ = false;
    value(content);
    first_ = false;
  }
  template <class Struct>
  void fields(const Struct& s) {
    visit_fields(
        s, [this](std::string_view key, const auto& content) __attribute__((always_inline)) {
          this->field(key, content);  // clang calls `this` unused without its name
        });
  }

 private:
  static constexpr std::size_t longest_number = 32;
  void null() { out_.append("null"); }

  JsonText& out_;
  bool first_ = true;  ///< of the object being written
};

/// JSON Lines into a file, handed over in blocks.
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

  /// False once a write failed, as to a closed pipe.
  bool flush();

 private:
  static constexpr std::size_t block = 64 * 1024;
  std::FILE* file_;
  JsonText text_{2 * block};
  bool sound_ = true;
};

}  // namespace drydock::cli
