#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <string_view>

namespace drydock::cli {

/// Text that grows at its end: ask for room once, write there, say where it ended.
class JsonText {
 public:
  explicit JsonText(std::size_t capacity = 256) : text_(new char[capacity]), capacity_(capacity) {}

  /// Where to write up to `size` characters; nothing counts before `end`.
  [[gnu::always_inline]] char* room(std::size_t size) {
    if (capacity_ - size_ < size) [[unlikely]]
      grow(size);
    return text_.get() + size_;
  }
  void end(const char* at) { size_ = static_cast<std::size_t>(at - text_.get()); }

  void append(std::string_view text) {
    char* const at = room(text.size());
    std::memcpy(at, text.data(), text.size());
    end(at + text.size());
  }
  void append(char c) {
    char* const at = room(1);
    *at = c;
    end(at + 1);
  }
  std::string_view view() const { return {text_.get(), size_}; }
  std::size_t size() const { return size_; }
  void clear() { size_ = 0; }

 private:
  void grow(std::size_t size);

  std::unique_ptr<char[]> text_;
  std::size_t capacity_, size_ = 0;
};

/// A finite number as JSON has it, with the fewest digits that read back as the same. Writes at
/// most 32 characters; the end of what was written.
char* write_number(char* at, double number);
char* write_number(char* at, float number);

}  // namespace drydock::cli
