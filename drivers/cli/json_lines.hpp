#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace drydock::cli {

/// Appends JSON values to a text. Doubles have the fewest digits that read back as the same number;
/// what JSON has no number for (NaN, infinity), empty optionals and empty strings are null.
class JsonWriter {
 public:
  explicit JsonWriter(std::string& out) : out_(out) {}

  void value(bool truth) { out_ += truth ? "true" : "false"; }
  void value(std::string_view text);
  template <std::floating_point T>
  void value(T number) {
    if (std::isfinite(number)) {
      append_number(number);
    } else {
      out_ += "null";
    }
  }
  template <std::integral T>
  void value(T number) {
    append_number(+number);  // a byte is a number, not a character
  }
  template <class T>
  void value(const std::optional<T>& maybe) {
    if (maybe) {
      value(*maybe);
    } else {
      out_ += "null";
    }
  }
  /// Arrays and spans of values or of structs with visit_fields.
  template <class Range>
  requires requires(const Range& range) { range.begin(), range.end(); }
  void value(const Range& range) {
    out_ += '[';
    bool first = true;
    for (const auto& item : range) {
      if (!first) out_ += ',';
      first = false;
      value(item);
    }
    out_ += ']';
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
    out_ += '{';
    first_ = true;
  }
  void close() {
    out_ += '}';
    first_ = false;
  }
  template <class T>
  void field(std::string_view key, const T& content) {
    if (!first_) out_ += ',';
    out_ += '"';
    out_ += key;
    out_ += "\":";
    first_ = false;
    value(content);
    first_ = false;
  }
  template <class Struct>
  void fields(const Struct& s) {
    visit_fields(s, [this](std::string_view key, const auto& content) {
      this->field(key, content);  // clang calls `this` unused without its name
    });
  }

 private:
  template <class T>
  void append_number(T number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr;
    out_.append(digits.data(), end);
  }

  std::string& out_;
  bool first_ = true;  ///< of the object being written
};

/// JSON Lines into a file, handed over in blocks.
class JsonLines {
 public:
  explicit JsonLines(std::FILE* file) : file_(file) { text_.reserve(2 * block); }

  /// Writes one line; `fill(JsonWriter&)` gives its fields.
  template <class Fill>
  void line(Fill&& fill) {
    JsonWriter writer(text_);
    writer.open();
    fill(writer);
    writer.close();
    text_ += '\n';
    if (text_.size() >= block) flush();
  }

  /// False once a write failed, as to a closed pipe.
  bool flush();

 private:
  static constexpr std::size_t block = 64 * 1024;
  std::FILE* file_;
  std::string text_;
  bool sound_ = true;
};

}  // namespace drydock::cli
