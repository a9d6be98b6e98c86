#pragma once

#include "tests/drivers/described/driven.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Drivers of sensors on a CAN bus, from a description and a DBC file, and what they say.
namespace drydock::described::test {

using wire::test::frame;

struct Bus final : Heard {
  explicit Bus(const DescriptionPtr& description, const std::string& protocol = "",
               std::uint8_t address = 0) {
    device::DriverOptions options;
    options.address = address;
    options.kind = description->kind.value();
    options.protocol = protocol.empty() ? description->name : protocol;
    if (protocol.empty()) options.description = description;
    driver = *device::make_frame_driver(options);
  }
  void says(const wire::CanFrame& one, double at_s) {
    driver->receive(one, Stamp{measurement::from_seconds(at_s)}, *this);
  }
  std::unique_ptr<device::FrameDriver> driver;
};

/// The truth through the emulated device, its bus and its driver.
inline void run(const DescriptionPtr& description, double rate_hz, double seconds, Bus& bus) {
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(description->kind.value(), description->name, rate_hz);
  config.description = description;
  emulate::EmulatedBus line(
      500'000, [&](const wire::CanFrame& one, std::size_t, const emulate::Passage& passage) {
        bus.driver->receive(one, passage.ended_at, bus);
      });
  line.add(emulate::make_emulated_device(config, truth, 1).value());
  shell::Lockstep lockstep(emulate::start);
  lockstep.add(line);
  lockstep.run_until(emulate::at_s(seconds));
}

// Frames by the tables of MT1604P: big-endian, 2^-9 rad/s, 2^-8 m/s2, ticks of 100 us.
inline const auto xsens_ticks = "005#000003E8", xsens_rate = "032#0033FF800500",
                  xsens_force = "034#0180FDC009CF";

// By SAE's table: lateral 0.25, longitudinal -1, vertical 9.81 m/s2; pitch 1, roll -0.5, yaw 2
// deg/s with a latency of 4 ms.
inline const auto mv5_force = "08F02DE2#197D9C7CD58000FF", mv5_rate = "0CF02AE2#807DC07C007E0008";

}  // namespace drydock::described::test
