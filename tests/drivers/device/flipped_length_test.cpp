#include "tests/drivers/device/gnss_receiver.hpp"

/// One bit of a frame's length is turned over. The frames behind it come out soon and with their
/// own times. 8N1: a byte takes 10 bits.
namespace drydock::device::test {
namespace flipped_length_test {

using std::chrono::nanoseconds;

/// A measurement and the time at which the driver gave it.
struct Told {
  measurement::Origin origin;
  Stamp at;
};

/// Sends frames to a driver, each in one read that ends with the frame's last byte.
class Sender {
 public:
  Sender(Kind kind, const std::string& protocol, std::optional<unsigned> baud) {
    DriverOptions o = options(kind, protocol);
    o.baud = baud;
    driver = byte_driver(o);
  }

  void send(const Octets& bytes, Stamp at) {
    wait_until(at);
    driver->receive(bytes, at, ear);
    note(at);
  }

  void wait_until(Stamp at) {
    for (auto due = driver->deadline(); due && *due <= at; due = driver->deadline()) {
      driver->tick(*due, ear);
      note(*due);
      ASSERT_NE(driver->deadline(), due) << "the driver asks for the same tick again";
    }
  }

  void note(Stamp at) {
    for (; told.size() < ear.heard.size();)
      told.push_back({measurement::origin_of(ear.heard[told.size()]), at});
  }

  Ear ear;
  std::unique_ptr<ByteDriver> driver;
  std::vector<Told> told;
};

Octets flipped(Octets frame, std::size_t byte, unsigned bit) {
  frame.at(byte) = static_cast<std::uint8_t>(frame[byte] ^ 1U << bit);
  return frame;
}

Octets golden_ensemble() {
  const Octets golden =
      read_all(std::filesystem::path(DRYDOCK_SOURCE_DIR) / "fixtures/pd0/golden.pd0");
  return {golden.begin(), golden.begin() + (golden.at(2) | golden.at(3) << 8) + 2};
}

/// Twenty sends at a steady rate, the third of which has one bit of its length turned over.
/// Expects 19 measurements: each with the time of its own send, none later than `delay` after it.
template <class Make>
void expect_the_others(Sender sender, Make&& make, double period_s, std::size_t byte, unsigned bit,
                       nanoseconds delay) {
  constexpr std::size_t sends = 20, damaged = 2;
  std::vector<Stamp> undamaged;
  for (std::size_t i = 0; i < sends; ++i) {
    const Stamp at = at_s(1 + period_s * static_cast<double>(i));
    sender.send(i == damaged ? flipped(make(i), byte, bit) : make(i), at);
    if (i != damaged) undamaged.push_back(at);
  }
  sender.wait_until(undamaged.back() + std::chrono::seconds{2});
  ASSERT_EQ(sender.told.size(), undamaged.size());
  for (std::size_t i = 0; i < undamaged.size(); ++i) {
    EXPECT_EQ(sender.told[i].origin.received_at, undamaged[i]) << i;
    EXPECT_LE(sender.told[i].at - undamaged[i], delay) << i;
  }
  const auto& counters = sender.driver->counters();
  EXPECT_GE(counters.bad_checksums, 1U);
  EXPECT_EQ(counters.bytes_in,
            counters.bytes_good + counters.bytes_skipped + sender.driver->held_bytes());
}

constexpr nanoseconds byte_time(unsigned baud) { return nanoseconds{10'000'000'000 / baud}; }

/// A length of the sent frame, and 4096 or 8192 bytes more.
TEST(FlippedLength, EnsemblesOfPd0AtFiveHertzKeepTheirTimes) {
  const Octets ensemble = golden_ensemble();
  const std::size_t size = ensemble.size();
  const auto make = [&](std::size_t) { return ensemble; };
  expect_the_others(Sender(Kind::dvl, "pd0", 115'200), make, 0.2, 3, 4,
                    (size + 4096) * byte_time(115'200));
  expect_the_others(Sender(Kind::dvl, "pd0", 115'200), make, 0.2, 3, 5,
                    std::chrono::milliseconds{500});
}

TEST(FlippedLength, FixesOfUbxAtOneHertzKeepTheirTimes) {
  const auto make = [](std::size_t i) {
    return nav_pvt({.itow_ms = static_cast<std::uint32_t>(1000 * i)});
  };
  constexpr auto claimed = (100 + 1024) * byte_time(38'400);
  expect_the_others(Sender(Kind::gnss, "ubx", 38'400), make, 1, 5, 2, claimed);
  expect_the_others(Sender(Kind::gnss, "ubx", 38'400), make, 1, 5, 3,
                    std::chrono::milliseconds{500});
}

/// A network tells no rate: then nothing waits for more than half a second.
TEST(FlippedLength, ALinkWithoutARateWaitsHalfASecondAtMost) {
  const Octets ensemble = golden_ensemble();
  expect_the_others(
      Sender(Kind::dvl, "pd0", {}), [&](std::size_t) { return ensemble; }, 0.2, 3, 4,
      std::chrono::milliseconds{500});
}

/// A peer that gives a byte a second, as a stuck gateway does: slow is not damaged.
TEST(FlippedLength, AFrameOfAByteASecondComesWhole) {
  Sender sender(Kind::gnss, "ubx", {});
  const Octets fix = nav_pvt({.itow_ms = 1000});
  for (std::size_t i = 0; i < fix.size(); ++i) sender.send({fix[i]}, at_s(static_cast<double>(i)));
  sender.wait_until(at_s(static_cast<double>(fix.size() + 2)));
  ASSERT_EQ(sender.told.size(), 1U);
  EXPECT_EQ(sender.told[0].origin.received_at, at_s(static_cast<double>(fix.size() - 1)));
  EXPECT_EQ(sender.driver->counters().bytes_skipped, 0U);
}

}  // namespace flipped_length_test
}  // namespace drydock::device::test
