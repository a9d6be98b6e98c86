#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// The line format of NMEA 0183 (IEC 61162-1): `$ttsss,field,field*hh` and a line end. hh is the
/// XOR of the characters between `$` and `*`. Any field may be empty; empty means "not available".
namespace drydock::wire {

/// The talker: GP, GN, VD, VM, ... Any two characters are valid.
struct Talker {
  std::array<char, 2> letters{};
  constexpr Talker() = default;
  constexpr explicit Talker(std::string_view text) : letters{text[0], text[1]} {}
  constexpr std::string_view text() const { return {letters.data(), letters.size()}; }
  friend bool operator==(const Talker&, const Talker&) = default;
};

/// One letter for a status or mode. '\0' if the field is empty or absent.
struct Letter {
  char value = '\0';
  constexpr Letter() = default;
  constexpr Letter(char letter) : value(letter) {}
  constexpr std::optional<std::string_view> text() const {
    return value ? std::optional{std::string_view{&value, 1}} : std::nullopt;
  }
  friend bool operator==(const Letter&, const Letter&) = default;
};

/// The sentence of a frame, without the TAG block in front of it.
Bytes without_tag(Bytes frame);

/// Reads the fields of a valid sentence from left to right. A field that is empty, missing at the
/// end or malformed reads as empty and never affects the others; position() joins two.
class SentenceReader {
 public:
  /// `frame` is a frame of the scan. A proprietary or malformed address, and a sentence that begins
  /// with `!`, give an empty `formatter()`.
  explicit SentenceReader(Bytes frame);

  Talker talker() const { return talker_; }
  std::string_view formatter() const { return formatter_; }  ///< GGA, VHW, ...

  std::size_t remaining() const;  ///< fields not yet read
  std::string_view text();
  Letter letter();
  /// A field that has the same letter in all such sentences, as M for metres. False if another one
  /// is there: then the fields are not those of the sentence. Empty or missing it says nothing.
  bool fixed(char letter);
  std::optional<double> number() { return optional_of<double>(&SentenceReader::take_number); }
  std::optional<int> integer() { return optional_of<int>(&SentenceReader::take_integer); }
  std::optional<int> hexadecimal();
  std::optional<double> angle() {
    return scaled(number(), radians(1));
  }                                   ///< degrees on the wire, rad here
  std::optional<double> direction();  ///< as angle(); empty too where it is not 0 to 360
  std::optional<double> latitude();   ///< ddmm.m,N|S; two fields; rad
  std::optional<double> longitude();  ///< dddmm.m,E|W; two fields; rad
  /// latitude() and longitude(): both, or none of them.
  void position(std::optional<double>& latitude_rad, std::optional<double>& longitude_rad);
  std::optional<double> eastward();                ///< degrees,E|W; two fields; rad
  std::optional<std::chrono::nanoseconds> time();  ///< hhmmss.s of the UTC day, also 23:59:60

 private:
  /// Inline, so that no optional is packed into a return value. Its flag would be written as one
  /// byte and read as eight, which stalls the processor at every field.
  template <class T>
  std::optional<T> optional_of(bool (SentenceReader::*take)(T&)) {
    T value{};
    return (this->*take)(value) ? std::optional{value} : std::nullopt;
  }
  bool take_number(double& value);
  bool take_integer(int& value);
  bool ends_field(const char* at) const { return at == end_ || *at == ','; }
  bool skip_empty() {
    if (at_ && !ends_field(at_)) return false;
    if (at_) pass(at_);
    return true;
  }
  void pass(const char* stop) { at_ = stop == end_ ? nullptr : stop + 1; }
  std::optional<double> coordinate(double limit_deg, char positive, char negative);

  const char* at_ = nullptr;  ///< start of the next field; nullptr: no more fields
  const char* end_ = nullptr;
  Talker talker_;
  std::string_view formatter_;
};

/// Digits after the point that a device sends. The defaults are those of a good receiver and log.
struct NmeaDecimals {
  int time = 2, minutes = 5, height = 2, dop = 2, angle = 2, speed = 3, distance = 3;
};

/// Writes one sentence, checksum and CR LF into a buffer. An empty value writes an empty field.
class SentenceWriter {
 public:
  SentenceWriter(std::span<std::uint8_t> out, Talker talker, std::string_view formatter);

  void text(std::string_view text);
  void letter(Letter letter);
  void number(const std::optional<double>& value, int decimals);
  void integer(const std::optional<int>& value, int width = 1);  ///< padded with zeros
  void hexadecimal(const std::optional<int>& digit);
  void angle(const std::optional<double>& radians, int decimals);
  void latitude(const std::optional<double>& radians, int decimals_of_minute);
  void longitude(const std::optional<double>& radians, int decimals_of_minute);
  void eastward(const std::optional<double>& radians, int decimals);
  void time(const std::optional<std::chrono::nanoseconds>& time_of_day, int decimals);

  std::size_t finish();  ///< bytes written, 0 if the buffer was too small

 private:
  void put(char c);
  void put(std::string_view text);
  void put_padded(std::int64_t value, int width);
  void coordinate(const std::optional<double>& radians, int degree_width, int decimals,
                  std::string_view hemispheres);

  std::span<std::uint8_t> out_;
  std::size_t size_ = 0;
  bool overflow_ = false;
};

}  // namespace drydock::wire
