#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace drydock::bus::test {

/// Plain CDR, little endian, written from the OMG rules. A primitive is aligned to its own size,
/// counted from the end of the four bytes of encapsulation. A string is its length including the
/// NUL, then its bytes. It checks independently how our messages look on the wire.
class CdrReader {
 public:
  explicit CdrReader(std::vector<std::uint8_t> bytes) : bytes_(std::move(bytes)) {}

  template <class T>
  T next() {
    at_ = (at_ + sizeof(T) - 1) / sizeof(T) * sizeof(T);
    T value{};
    if (encapsulation + at_ + sizeof(T) > bytes_.size()) throw std::out_of_range("CDR too short");
    std::memcpy(&value, bytes_.data() + encapsulation + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }

  std::string next_string() {
    std::string text;
    for (auto left = next<std::uint32_t>(); left > 1; --left) text.push_back(next<char>());
    next<char>();
    return text;
  }

  std::vector<double> next_doubles(std::size_t count) {
    std::vector<double> values(count);
    for (auto& value : values) value = next<double>();
    return values;
  }

  const std::vector<std::uint8_t>& bytes() const { return bytes_; }
  bool is_plain_little_endian() const { return bytes_.at(0) == 0 && bytes_.at(1) == 1; }
  std::size_t size() const { return bytes_.size(); }

 private:
  static constexpr std::size_t encapsulation = 4;

  std::vector<std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace drydock::bus::test
