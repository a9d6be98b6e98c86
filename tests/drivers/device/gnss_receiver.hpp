#pragma once

#include "tests/drivers/device/support.hpp"

/// A receiver that sends the test's text, and messages built from the offsets in the u-blox
/// interface descriptions.
namespace drydock::device::test {

struct Pvt {
  std::uint32_t itow_ms = 1000;
  std::uint8_t fix_type = 3, flags = 0x01;
  std::uint16_t flags3 = 0;
};

inline Octets nav_pvt(const Pvt& p) {
  Octets m(92, 0);
  put(m, 0, 4, p.itow_ms);
  put(m, 4, 2, 2026);
  m[6] = 3, m[7] = 4, m[8] = 5, m[9] = 6, m[10] = 7;
  m[11] = 0x07;             // date, time valid, fully resolved
  put(m, 16, 4, -250'000);  // ns: just before the full second
  m[20] = p.fix_type;
  m[21] = p.flags;
  m[23] = 11;
  put(m, 24, 4, 85'000'000);   // 8.5 deg east
  put(m, 28, 4, 472'500'000);  // 47.25 deg north
  put(m, 32, 4, 450'000);
  put(m, 36, 4, 402'000);
  put(m, 40, 4, 1'500);
  put(m, 48, 4, 1'000);
  put(m, 52, 4, -500);
  put(m, 56, 4, 250);
  put(m, 76, 2, 123);
  put(m, 78, 2, p.flags3);
  return ubx(0x01, 0x07, m);
}

inline Octets nav_eoe(std::uint32_t itow_ms) {
  Octets m(4, 0);
  put(m, 0, 4, itow_ms);
  return ubx(0x01, 0x61, m);
}

/// Two satellites: Galileo 5 used at 41 dBHz, GLONASS 7 in view, its elevation unknown.
inline Octets nav_sat(std::uint32_t itow_ms) {
  Octets m(8 + 2 * 12, 0);
  put(m, 0, 4, itow_ms);
  m[4] = 1, m[5] = 2;
  m[8] = 2, m[9] = 5, m[10] = 41, m[11] = 30;
  put(m, 12, 2, 270);
  put(m, 16, 4, 0x0000001F);
  m[20] = 6, m[21] = 7, m[22] = 0, m[23] = static_cast<std::uint8_t>(-91);
  return ubx(0x01, 0x35, m);
}

struct Receiver {
  explicit Receiver(std::string protocol, std::optional<unsigned> baud = {}) {
    DriverOptions o = options(Kind::gnss, std::move(protocol));
    o.baud = baud;
    driver = byte_driver(o);
  }
  void says(const Octets& bytes, double at) { driver->receive(bytes, at_s(at), ear); }
  std::vector<measurement::GnssFix> fixes() const { return ear.all<measurement::GnssFix>(); }
  std::vector<measurement::GnssSatellites> skies() const {
    return ear.all<measurement::GnssSatellites>();
  }

  Ear ear;
  std::unique_ptr<ByteDriver> driver;
};

}  // namespace drydock::device::test
