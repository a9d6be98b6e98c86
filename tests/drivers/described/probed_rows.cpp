#include "tests/drivers/described/probed_rows.hpp"

#include <map>

#include "drivers/device/make_driver.hpp"
#include "drivers/survey/bus_survey.hpp"
#include "drivers/wire/registry.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::described::test {
namespace {

using measurement::Stamp;
using survey::BusSurvey;
using survey::ByteSurvey;
using survey::SensorHeard;

constexpr double listened_s = 12;

/// A host: what its driver says reaches the device.
struct Host final : device::Output {
  void publish(const measurement::Measurement&) override {}
  void send(wire::Bytes bytes) override { line->receive(bytes, now); }
  void send(const wire::CanFrame& frame) override { bus->receive(frame, now); }
  void report(std::string_view) override {}

  emulate::EmulatedLine* line = nullptr;
  emulate::EmulatedBus* bus = nullptr;
  Stamp now = emulate::start;
};

rig_config::DeviceConfig config_of(const Probed& probed) {
  auto config = emulate::device(probed.kind, probed.protocol, 5);
  config.description = probed.description;
  return config;
}

device::DriverOptions options_of(const Probed& probed) {
  device::DriverOptions options;
  options.kind = probed.kind;
  options.protocol = probed.protocol;
  options.description = probed.description;
  options.poll_period = std::chrono::milliseconds{200};
  options.address = static_cast<std::uint8_t>(config_of(probed).address);
  return options;
}

std::unique_ptr<emulate::EmulatedDevice> made(const Probed& probed,
                                              const motion::Trajectory& truth) {
  return emulate::make_emulated_device(config_of(probed), truth, 1).value();
}

void run(shell::Actor& actor, auto& driver, Host& host) {
  if (driver) driver->restart(host.now, host);
  shell::Lockstep lockstep(emulate::start);
  lockstep.add(actor);
  for (double t = 0; t <= listened_s; t += 0.01) {
    lockstep.run_until(host.now = emulate::at_s(t));
    if (!driver) continue;
    if (const auto due = driver->deadline(); due && *due <= host.now) driver->tick(host.now, host);
  }
}

std::vector<SensorHeard> on_a_line(const Probed& probed, ByteSurvey& survey) {
  const emulate::Frozen truth(emulate::at_the_surface());
  Host host;
  std::unique_ptr<device::ByteDriver> driver;
  if (probed.with_host) driver = *device::make_byte_driver(options_of(probed));
  emulate::EmulatedLine line(made(probed, truth), 115200,
                             [&](wire::Bytes bytes, const emulate::Passage& passage) {
                               survey.feed(bytes, host.now = passage.ended_at);
                               if (driver) driver->receive(bytes, host.now, host);
                             });
  host.line = &line;
  run(line, driver, host);
  survey.finish();
  return survey::sensors_of(survey.findings());
}

std::vector<SensorHeard> on_a_bus(const Probed& probed, BusSurvey& survey) {
  const emulate::Frozen truth(emulate::at_the_surface());
  Host host;
  std::unique_ptr<device::FrameDriver> driver;
  if (probed.with_host) driver = *device::make_frame_driver(options_of(probed));
  emulate::EmulatedBus bus(
      250'000, [&](const wire::CanFrame& frame, std::size_t, const emulate::Passage& passage) {
        survey.receive(frame, host.now = passage.ended_at);
        if (driver) driver->receive(frame, host.now, host);
      });
  bus.add(made(probed, truth));
  host.bus = &bus;
  run(bus, driver, host);
  std::vector<SensorHeard> all;
  for (const auto& node : survey.nodes())
    all.insert(all.end(), node.sensors.begin(), node.sensors.end());
  return all;
}

/// The last values of a driver, by name.
using Values = std::map<std::string, double>;

struct Reader final : device::Output {
  void publish(const measurement::Measurement& m) override {
    if (const auto* imu = std::get_if<measurement::ImuSample>(&m)) {
      note("force", imu->specific_force);
      note("rate", imu->angular_rate);
    }
    if (const auto* dvl = std::get_if<measurement::BottomVelocity>(&m); dvl && dvl->velocity)
      note("velocity", *dvl->velocity);
    if (const auto* tilt = std::get_if<measurement::AttitudeSample>(&m)) {
      if (tilt->true_heading_rad) values["heading"] = *tilt->true_heading_rad;
      if (tilt->roll_rad) values["roll"] = *tilt->roll_rad;
    }
  }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  void report(std::string_view) override {}
  void note(const std::string& name, const Eigen::Vector3d& v) {
    for (int i = 0; i < 3; ++i) values[name + std::to_string(i)] = v[i];
  }

  Values values;
};

/// What the driver of `read_as` reads of the device.
Values values_of(const Probed& device, const Probed& read_as) {
  const emulate::Frozen truth(emulate::at_the_surface());
  emulate::Recorder sent;
  sent.run(*made(device, truth), emulate::at_s(listened_s));
  Reader reader;
  if (device.travels == wire::Travels::as_frames) {
    const auto driver = *device::make_frame_driver(options_of(read_as));
    for (const auto& one : sent.frames) driver->receive(one.frame, one.at, reader);
  } else {
    const auto driver = *device::make_byte_driver(options_of(read_as));
    for (const auto& one : sent.messages) driver->receive(one.bytes, one.at, reader);
  }
  return reader.values;
}

/// True if the second has all values of the first.
bool are_same(const Values& described, const Values& by_hand) {
  return !described.empty() && std::ranges::all_of(described, [&](const auto& value) {
    const auto found = by_hand.find(value.first);
    return found != by_hand.end() && std::abs(found->second - value.second) < 1e-6;
  });
}

bool has(const std::vector<SensorHeard>& sensors, const Probed& probed) {
  return std::ranges::any_of(sensors, [&](const auto& one) {
    return one.kind == probed.kind && one.protocol == probed.protocol;
  });
}

}  // namespace

std::vector<SensorHeard> sensors_heard(const Probed& probed,
                                       const std::vector<DescriptionPtr>& named, bool alone) {
  if (probed.travels == wire::Travels::as_frames) {
    BusSurvey survey(named);
    return on_a_bus(probed, survey);
  }
  ByteSurvey survey(named, alone ? ByteSurvey::Descriptions{} : rig_config::shipped_descriptions());
  return on_a_line(probed, survey);
}

std::string probed_cell(Probed device) {
  const std::vector<DescriptionPtr> named{device.description};
  for (const bool described : {false, true})
    for (const bool with_host : {false, true}) {
      device.with_host = with_host;
      if (described && !device.description) continue;
      if (!has(sensors_heard(device, described ? named : std::vector<DescriptionPtr>{}), device))
        continue;
      const std::string how = described ? "`--describe`" : "yes";
      return with_host ? how + ", while a host speaks" : how;
    }
  return "no";
}

std::string by_hand_beside(const Probed& device) {
  const Values described = values_of(device, device);
  for (const auto& protocol : wire::protocols()) {
    if (!protocol.kinds.has(device.kind) || protocol.travels != device.travels) continue;
    const Values by_hand = values_of(device, {device.kind, std::string(protocol.name)});
    if (are_same(described, by_hand)) return std::string(protocol.name);
  }
  return {};
}

bool is_named_on_golden_bytes(const std::string& protocol) {
  using namespace wire::testing;
  if (protocol == "j1939" || protocol == "can") {
    BusSurvey survey;
    const auto name = protocol == "can" ? "xsens" : "j1939";
    for (const auto& frame :
         wire::test::frames_of_log(wire::test::fixture(std::string(name) + "/frames.log")))
      survey.receive(frame, Stamp{});
    const auto kind = protocol == "can" ? survey::NodeKind::plain : survey::NodeKind::j1939;
    return std::ranges::any_of(survey.nodes(), [&](const auto& n) { return n.kind == kind; });
  }
  Buffer bytes;
  if (protocol == "ubx+nmea0183")
    bytes = fixture("ubx/golden.ubx") + fixture("nmea0183/golden.nmea");
  if (protocol == "mavlink") bytes = fixture("mavlink/autopilot.mavlink");
  if (protocol == "slcan")
    for (int i = 0; i < 20; ++i) bytes = bytes + wire::testing::as_bytes("t18181122334455667788\r");
  ByteSurvey survey({}, rig_config::shipped_descriptions());
  survey.feed(bytes, Stamp{});
  survey.finish();
  return survey.best().protocol == protocol;
}

}  // namespace drydock::described::test
