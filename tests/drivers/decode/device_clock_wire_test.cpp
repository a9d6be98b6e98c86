// By its own clock a device's message begins on the wire when it says, whatever else the line
// carries. The frames are built here from u-blox's interface description.
#include <gtest/gtest.h>

#include <cstdint>

#include "drivers/decode/replay.hpp"
#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace device_clock_wire_test {

using Payload = std::string;

std::string frame(std::uint8_t message_class, std::uint8_t id, const Payload& payload) {
  std::string body{static_cast<char>(message_class), static_cast<char>(id),
                   static_cast<char>(payload.size() & 0xFF),
                   static_cast<char>(payload.size() >> 8)};
  body += payload;
  std::uint8_t a = 0, b = 0;
  for (const char byte : body)
    b = static_cast<std::uint8_t>(
        b + (a = static_cast<std::uint8_t>(a + static_cast<std::uint8_t>(byte))));
  return "\xB5\x62" + body + static_cast<char>(a) + static_cast<char>(b);
}

void put(Payload& payload, std::size_t at, std::uint32_t value, std::size_t bytes = 4) {
  for (std::size_t i = 0; i < bytes; ++i) payload[at + i] = static_cast<char>(value >> (8 * i));
}

/// A fix in three dimensions at 08:00:00 of a Saturday, and 20 s at most behind it.
std::string nav_pvt(std::uint32_t itow_ms) {
  Payload payload(92, '\0');
  put(payload, 0, itow_ms);
  put(payload, 4, 2026, 2);
  put(payload, 6, 11, 1);
  put(payload, 7, 21, 1);
  put(payload, 8, 8, 1);
  put(payload, 10, itow_ms / 1000 % 60, 1);
  put(payload, 11, 0x37, 1);
  put(payload, 20, 3, 1);
  put(payload, 21, 1, 1);
  put(payload, 23, 12, 1);
  put(payload, 24, 1'512'500'000);
  return frame(0x01, 0x07, payload);
}

std::string nav_eoe(std::uint32_t itow_ms) {
  Payload payload(4, '\0');
  put(payload, 0, itow_ms);
  return frame(0x01, 0x61, payload);
}

/// 340 bytes that tell no time.
std::string five_mon_hw() {
  std::string all;
  for (int i = 0; i < 5; ++i) all += frame(0x0A, 0x09, Payload(60, '\0'));
  return all;
}

constexpr std::uint32_t first_itow_ms = 547'218'000, step_ms = 200;

/// valid_at of the fixes, milliseconds of the week.
std::vector<double> fixes_valid_at_ms(const std::string& bytes) {
  const TemporaryFile file(bytes);
  ReplayOptions options;
  options.capture = file.path();
  options.protocol = "ubx";
  options.baud = 38400;
  std::vector<double> valid_at_ms;
  play(options, [&](const measurement::Measurement& m) {
    const auto& origin = measurement::origin_of(m);
    valid_at_ms.push_back(measurement::seconds(origin.valid_at.time_since_epoch()) * 1e3);
    // 100 bytes of ten bits at 38400 baud.
    EXPECT_NEAR(measurement::seconds(origin.received_at - origin.valid_at), 1000 / 38400.0, 1e-7);
  });
  return valid_at_ms;
}

void expect_own_times(const std::vector<double>& valid_at_ms) {
  ASSERT_EQ(valid_at_ms.size(), 20u);
  for (std::size_t i = 0; i < valid_at_ms.size(); ++i)
    EXPECT_NEAR(valid_at_ms[i], first_itow_ms + i * double{step_ms}, 1e-3) << i;
}

template <class Epoch>
std::string twenty(const Epoch& epoch) {
  std::string all;
  for (std::uint32_t i = 0; i < 20; ++i) all += epoch(first_itow_ms + i * step_ms);
  return all;
}

TEST(DeviceClock, AFixIsValidAtItsTimeOfWeekWhateverElseTheReceiverSends) {
  expect_own_times(fixes_valid_at_ms(twenty([](auto t) { return nav_pvt(t) + five_mon_hw(); })));
  expect_own_times(fixes_valid_at_ms(twenty([](auto t) { return five_mon_hw() + nav_pvt(t); })));
  expect_own_times(fixes_valid_at_ms(twenty([](auto t) { return nav_pvt(t) + nav_eoe(t); })));
}

}  // namespace device_clock_wire_test
}  // namespace drydock::decode
