#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace drydock::wire {

/// Reads one line of JSON (RFC 8259) from left to right, without memory of its own. Each call reads
/// one value. A value of another kind is passed over and reads as empty, and so does everything
/// after an error. NaN and Infinity, which JSON does not know, are numbers without a value. A line
/// end is an error: it means that the line was torn.
class JsonReader {
 public:
  static constexpr int deepest = 8;  ///< values inside values; deeper ones are an error

  explicit JsonReader(std::string_view text) : text_(text) {}

  bool sound() const { return state_ == State::sound; }
  bool cut() const { return state_ == State::cut; }  ///< the text ends inside a value
  std::size_t at() const { return at_; }             ///< characters read

  /// Calls `member(key)` for each member; that must read the value. The key is as it is written.
  template <class F>
  void object(F&& member) {
    each('{', '}', [&] {
      const std::string_view key = string();
      expect(':');
      if (sound()) member(key);
    });
  }

  /// Calls `element()` for each element; that must read it.
  template <class F>
  void array(F&& element) {
    each('[', ']', element);
  }

  std::optional<double> number();  ///< finite
  std::optional<bool> boolean();
  std::string_view text();  ///< as it is written: escapes are not resolved
  std::string_view raw();   ///< any value, as it is written
  void skip();

 private:
  enum class State : std::uint8_t { sound, cut, broken };

  template <class F>
  void each(char open, char close, F&& item) {
    if (peek() != open) return skip();
    if (++depth_ > deepest) state_ = State::broken;
    ++at_;
    if (peek() != close) {
      do {
        item();
      } while (sound() && accept(','));
    }
    expect(close);
    --depth_;
  }

  /// The next character that is no blank; 0: there is none, or an error before.
  char peek() {
    if (!sound()) return '\0';
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    if (at_ < text_.size()) return text_[at_];
    state_ = State::cut;
    return '\0';
  }
  bool accept(char wanted) {
    if (peek() != wanted) return false;
    ++at_;
    return true;
  }
  void expect(char wanted) {
    if (!accept(wanted) && sound()) state_ = State::broken;
  }
  std::string_view string();
  void escape();
  std::string_view word();  ///< a number, true, false, null

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  State state_ = State::sound;
};

}  // namespace drydock::wire
