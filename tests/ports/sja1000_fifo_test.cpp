// The receive FIFO of an SJA1000 holds 64 bytes (its data sheet, 6.4.13), so four frames with 29
// bits of identifier and 8 bytes of data, 13 bytes each. What comes after them is lost if the
// processor does not read in time.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "drivers/link/can/can_interface.hpp"
#include "drivers/link/descriptor.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/ports/can.hpp"
#include "tests/ports/driver.hpp"

namespace drydock::ports {
namespace {

using device::State;
using fault::testing::Bench;
using namespace std::chrono_literals;
namespace n2k = wire::nmea2000;

constexpr double m_per_fix = 10;

/// Of /sys/class/net/NAME/statistics, which `ip -statistics -details link` prints.
std::uint64_t counted(const std::string& name, const std::string& what) {
  std::ifstream file("/sys/class/net/" + name + "/statistics/" + what);
  std::uint64_t count = 0;
  EXPECT_TRUE(file >> count) << name << " " << what;
  return count;
}

/// As long as it lives, the card's interrupt does not reach the processor, which is as deaf as one
/// that is busy with another: bit 10 of the PCI command register, "interrupt disable" (PCI 2.3).
class Deaf {
 public:
  explicit Deaf(const std::string& name)
      : registers_(::open(("/sys/class/net/" + name + "/device/config").c_str(), O_RDWR)) {
    set(true);
  }
  Deaf(const Deaf&) = delete;
  Deaf& operator=(const Deaf&) = delete;
  ~Deaf() { set(false); }

 private:
  void set(bool deaf) const {
    constexpr off_t command = 4;
    constexpr std::uint16_t interrupt_disable = 1 << 10;
    std::uint16_t bits = 0;
    ASSERT_EQ(::pread(registers_.get(), &bits, sizeof bits, command), 2);
    bits = static_cast<std::uint16_t>(deaf ? bits | interrupt_disable : bits & ~interrupt_disable);
    ASSERT_EQ(::pwrite(registers_.get(), &bits, sizeof bits, command), 2);
  }

  link::Descriptor registers_;
};

/// A receiver whose every value tells the number of its fix.
class NumberedGnss {
 public:
  NumberedGnss(link::asio::io_context& io, const std::string& name)
      : io_(io),
        name_(name),
        bus_(link::testing::open_bus(io, "socketcan:" + name, link::Side::device)) {}

  /// PGN 129029, seven frames; returns when the controller has sent them.
  void send(unsigned number) {
    n2k::GnssPosition fix;
    fix.source = 35;
    fix.sequence = static_cast<std::uint8_t>(number);
    fix.method = 1;
    fix.latitude_rad = fix.longitude_rad = number * 1e-3;
    fix.altitude_m = number * m_per_fix;
    std::array<std::uint8_t, n2k::GnssPosition::bytes> bytes{};
    n2k::encode_payload(fix, std::span(bytes));
    const auto sent = counted(name_, "tx_packets");
    const auto frames = wire::fast_packet_frames(bytes.size());
    for (std::size_t i = 0; i < frames; ++i)
      ASSERT_TRUE(
          link::testing::run(io_, bus_->write(wire::encode_fast_packet(
                                      n2k::identifier_of(fix), *fix.sequence & 7, bytes, i))));
    ASSERT_TRUE(link::testing::run_until(
        io_, [&] { return counted(name_, "tx_packets") >= sent + frames; }));
  }

 private:
  link::asio::io_context& io_;
  std::string name_;
  std::unique_ptr<link::FrameLink> bus_;
};

rig_config::DeviceConfig gnss_on(const std::string& name) {
  auto config = depth_on(name);
  config.name = "gnss";
  config.kind = rig_config::DeviceKind::gnss;
  config.stale_after_s = 10;
  return config;
}

/// The numbers of the fixes that were published; of a torn fix, that of none.
std::vector<double> numbers_of(const std::vector<measurement::Measurement>& heard) {
  std::vector<double> numbers;
  for (const auto& one : heard) {
    const auto& fix = std::get<measurement::GnssFix>(one);
    const double number = *fix.ellipsoidal_height_m / m_per_fix;
    const bool whole = std::abs(fix.position->latitude_rad - number * 1e-3) < 1e-9 &&
                       std::abs(fix.position->longitude_rad - number * 1e-3) < 1e-9;
    numbers.push_back(whole ? std::round(number) : -1);
  }
  return numbers;
}

TEST(Sja1000Fifo, WhatItLosesIsNamedAndCountedAndNoValueIsTorn) {
  runs_on({"can0", "can1"});
  bring_up("can0", "bitrate 250000");
  bring_up("can1", "bitrate 250000");
  {
    Bench bench(gnss_on("can0"), fault::testing::nobody);
    ASSERT_TRUE(bench.reaches(State::waiting));
    NumberedGnss gnss(bench.io, "can1");
    const auto overruns = counted("can0", "rx_over_errors");
    for (unsigned number = 1; number <= 3; ++number) gnss.send(number);
    ASSERT_TRUE(bench.until([&] { return bench.heard.size() == 3; }));
    {
      const Deaf deaf("can0");
      for (unsigned number = 4; number <= 6; ++number) gnss.send(number);
    }
    ASSERT_TRUE(bench.until([&] { return bench.health().error_frames > 0; }));
    EXPECT_NE(bench.health().last_error.view().find("receive overflow"), std::string_view::npos)
        << bench.health().last_error.view();
    bench.pass(wire::FastPacketAssembler::next_frame + 100ms);  // the rest does not come any more
    for (unsigned number = 7; number <= 8; ++number) gnss.send(number);
    ASSERT_TRUE(bench.until([&] { return bench.heard.size() >= 5; }));

    EXPECT_EQ(numbers_of(bench.heard), (std::vector<double>{1, 2, 3, 7, 8}));
    EXPECT_EQ(bench.health().error_frames, counted("can0", "rx_over_errors") - overruns);
    // Of the fourth fix four frames were heard, of the fifth and sixth none.
    EXPECT_EQ(bench.health().stream.bad_checksums, 1u);
    EXPECT_EQ(bench.health().stream.bytes_good, 5 * 7 * 8 + 4 * 8u);
    EXPECT_EQ(bench.states.back(), State::streaming);
  }
  for (const char* name : {"can0", "can1"}) EXPECT_FALSE(link::set_interface_up(name, false));
}

}  // namespace
}  // namespace drydock::ports
