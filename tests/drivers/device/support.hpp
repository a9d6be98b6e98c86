#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/device/device.hpp"

/// Common parts of the driver tests: listeners, clocks, and bytes written by hand from the
/// protocols' documents (never by our own encoders).
namespace drydock::device::test {

using measurement::from_seconds;
using Octets = std::vector<std::uint8_t>;

constexpr double degree = std::numbers::pi / 180;
constexpr double knot = 1852.0 / 3600.0;

inline Stamp at_s(double s) { return Stamp{from_seconds(s)}; }

/// Receives the output of a driver.
struct Ear final : Output {
  void publish(const Measurement& m) override { heard.push_back(m); }
  void send(wire::Bytes bytes) override { sent_bytes.emplace_back(bytes.begin(), bytes.end()); }
  void send(const wire::CanFrame& frame) override { sent_frames.push_back(frame); }
  void report(std::string_view text) override { reports.emplace_back(text); }
  void refuse(std::string_view why, Refusal) override { refusals.emplace_back(why); }

  template <class T>
  std::vector<T> all() const {
    std::vector<T> found;
    for (const Measurement& m : heard) {
      if (const T* t = std::get_if<T>(&m)) found.push_back(*t);
    }
    return found;
  }

  std::vector<Measurement> heard;
  std::vector<Octets> sent_bytes;
  std::vector<wire::CanFrame> sent_frames;
  std::vector<std::string> reports, refusals;
};

inline DriverOptions options(Kind kind, std::string protocol) {
  DriverOptions o;
  o.kind = kind;
  o.protocol = std::move(protocol);
  return o;
}

inline std::unique_ptr<ByteDriver> byte_driver(const DriverOptions& o) {
  return *make_byte_driver(o);
}

inline std::unique_ptr<FrameDriver> frame_driver(const DriverOptions& o) {
  return *make_frame_driver(o);
}

inline Octets octets(std::string_view text) { return {text.begin(), text.end()}; }

/// `$body*hh CR LF`, where hh is the XOR of the body.
inline Octets nmea(std::string_view body) {
  unsigned sum = 0;
  for (const char c : body) sum ^= static_cast<unsigned char>(c);
  std::array<char, 3> hex{};
  std::snprintf(hex.data(), hex.size(), "%02X", sum);
  return octets("$" + std::string(body) + "*" + hex.data() + "\r\n");
}

inline Octets operator+(Octets a, const Octets& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Writes a little-endian number of `size` bytes at `offset`.
inline void put(Octets& out, std::size_t offset, std::size_t size, std::int64_t value) {
  for (std::size_t i = 0; i < size; ++i) {
    out.at(offset + i) = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
  }
}

inline Octets ubx(std::uint8_t message_class, std::uint8_t id, const Octets& payload) {
  Octets frame{0xB5,
               0x62,
               message_class,
               id,
               static_cast<std::uint8_t>(payload.size() & 0xFF),
               static_cast<std::uint8_t>(payload.size() >> 8)};
  frame = frame + payload;
  std::uint8_t a = 0, b = 0;
  for (std::size_t i = 2; i < frame.size(); ++i) {
    a = static_cast<std::uint8_t>(a + frame[i]);
    b = static_cast<std::uint8_t>(b + a);
  }
  return frame + Octets{a, b};
}

inline wire::CanFrame can_frame(std::uint32_t id, bool extended,
                                std::initializer_list<unsigned> data) {
  wire::CanFrame frame;
  frame.id = id;
  frame.extended = extended;
  for (const unsigned byte : data) frame.data[frame.size++] = static_cast<std::uint8_t>(byte);
  return frame;
}

inline std::filesystem::path corpora() {
  const char* set = std::getenv("DRYDOCK_CORPORA");
  return set ? std::filesystem::path(set)
             : std::filesystem::path(DRYDOCK_SOURCE_DIR) / "../shared/corpora";
}

inline Octets read_all(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace drydock::device::test
