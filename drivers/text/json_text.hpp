#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string_view>

namespace drydock::text {

/// Text that grows at its end. Who writes holds the end and hands it on, so that it can stay in a
/// register: ask for room from there on, write, say in the end where it ended.
class JsonText {
 public:
  explicit JsonText(std::size_t capacity = 256)
      : text_(new char[capacity]), end_(text_.get()), limit_(end_ + capacity) {}

  char* end() const { return end_; }
  void end(char* at) { end_ = at; }

  /// Where what was written up to `at` stands, with room for `size` characters more.
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

/// A finite number as JSON has it, with the fewest digits that read back as the same. Writes at
/// most `longest_number` characters; the end of what was written.
inline constexpr std::size_t longest_number = 32;
char* write_number(char* at, double number);
char* write_number(char* at, float number);
char* write_number(char* at, std::int64_t number);
char* write_number(char* at, std::uint64_t number);

}  // namespace drydock::text
