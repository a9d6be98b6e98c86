#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace drydock::text {

/// Text that grows at its end. The writer holds the end and passes it on, so that it stays in a
/// register. Call room() with the end, write, and report the new end when all is written.
class JsonText {
 public:
  explicit JsonText(std::size_t capacity = 256)
      : text_(new char[capacity]), end_(text_.get()), limit_(end_ + capacity) {}

  char* end() const { return end_; }
  void end(char* at) { end_ = at; }

  /// Makes room for `size` more characters behind `at`. Gives the new position of `at`, since the
  /// text may move.
  [[gnu::always_inline]] char* room(char* at, std::size_t size) {
    return static_cast<std::size_t>(limit_ - at) < size ? grow(at, size) : at;
  }

  void append(char c) {
    end_ = room(end_, 1);
    *end_++ = c;
  }
  std::string_view view() const { return {text_.get(), size()}; }
  std::size_t size() const { return static_cast<std::size_t>(end_ - text_.get()); }
  void clear() { end_ = text_.get(); }

 private:
  char* grow(char* at, std::size_t size);

  std::unique_ptr<char[]> text_;
  char *end_, *limit_;
};

/// Writes a finite number as JSON, with the fewest digits that read back as the same number. Writes
/// at most `longest_number` characters. Returns the end of the written text.
inline constexpr std::size_t longest_number = 32;
char* write_number(char* at, double number);
char* write_number(char* at, float number);
char* write_number(char* at, std::int64_t number);
char* write_number(char* at, std::uint64_t number);

}  // namespace drydock::text
