#include "drivers/device/make_driver.hpp"
#include "drivers/survey/byte_survey.hpp"
#include "hil/emulate/lockstep.hpp"
#include "tests/drivers/described/support.hpp"
#include "tests/drivers/device/allocation_count.hpp"
#include "tests/hil/emulate/bench.hpp"

/// Drivers and emulated devices of descriptions.
namespace drydock::described::test {
namespace {

using measurement::Kind;
using measurement::Stamp;

struct Heard final : device::Output {
  void publish(const measurement::Measurement& m) override { all.push_back(m); }
  void send(wire::Bytes bytes) override { sent.emplace_back(bytes.begin(), bytes.end()); }
  void send(const wire::CanFrame&) override {}
  void report(std::string_view what) override { reports.emplace_back(what); }
  void refuse(std::string_view why, device::Refusal) override { refusals.emplace_back(why); }

  template <class Sample>
  const Sample& last() const {
    return std::get<Sample>(all.back());
  }

  std::vector<measurement::Measurement> all;
  std::vector<std::string> sent, reports, refusals;
};

device::DriverOptions options_of(const DescriptionPtr& description) {
  device::DriverOptions options;
  options.kind = description->kind;
  options.protocol = description->name;
  options.description = description;
  options.poll_period = std::chrono::milliseconds{500};
  return options;
}

std::unique_ptr<device::ByteDriver> driver_of(const DescriptionPtr& description) {
  return std::move(*device::make_byte_driver(options_of(description)));
}

void receive(device::ByteDriver& driver, const std::string& bytes, Stamp at, Heard& heard) {
  driver.receive({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, at, heard);
}

TEST(DescribedDrivers, TheLineTimeAndTheStatedAgeGiveTheTimeOfValidity) {
  auto options = options_of(shipped("nortek-bt.toml"));
  options.baud = 9600;
  Heard heard;
  const auto driver = std::move(*device::make_byte_driver(options));
  const std::string line =
      "$PNORBT7,1452244916.7508,1.234,-1.234,0.1234,0.1234,0.1234,12.34,23.45,23.45,23.45,23.45*"
      "39\r\n";
  const Stamp end = measurement::stamp_from_ns(1'000'000'000);
  receive(*driver, line, end, heard);
  ASSERT_EQ(heard.all.size(), 1u);
  const auto& sample = heard.last<measurement::BottomVelocity>();
  // 10 bits a byte at 9600 baud, then the age of 1.234 ms.
  const double line_s = static_cast<double>(line.size()) * 10 / 9600;
  EXPECT_NEAR(measurement::seconds(end - sample.origin.valid_at), line_s + 1.234e-3, 1e-6);
  EXPECT_NEAR(measurement::seconds(*sample.origin.device_time), 1452244916.7508, 1e-6);
  EXPECT_DOUBLE_EQ(sample.velocity->x(), 0.1234);
}

TEST(DescribedDrivers, AMisfitAndAFieldThatIsNoNumberAreTold) {
  Heard heard;
  const auto driver = driver_of(shipped("valeport-vat.toml"));
  receive(*driver, "$PRVAT,1,M*3D\r\n", {}, heard);  // too few fields; XOR by hand
  EXPECT_TRUE(heard.all.empty());
  ASSERT_EQ(heard.refusals.size(), 1u);
  receive(*driver, "$PRVAT,x,M,0010.073,dBar*5A\r\n", {}, heard);
  EXPECT_EQ(heard.reports.size(), 1u);
  ASSERT_EQ(heard.all.size(), 1u) << "the other field counts";
  EXPECT_FALSE(heard.last<measurement::DepthSample>().altitude_m);
}

TEST(DescribedDrivers, AKellerIsInitialisedThenPolledAndItsEchoIsReadAway) {
  const std::string initialise("\xFA\x30\x04\x43", 4), poll("\xFA\x49\x01\xA1\xA7", 5);
  const std::string answer("\xFA\x30\x05\x14\x05\x20\x0A\x00\xC3\xC8", 10);
  const std::string pressure("\xFA\x49\x3F\x81\xB2\x2D\x00\x18\xCE", 9);
  Heard heard;
  const auto driver = driver_of(shipped("keller.toml"));
  const auto at = [](double s) { return Stamp{measurement::from_seconds(s)}; };
  driver->restart(at(0), heard);
  EXPECT_EQ(heard.sent, (std::vector{initialise}));
  driver->tick(at(0.3), heard);
  EXPECT_EQ(heard.sent.size(), 2u) << "asked again without an answer";
  receive(*driver, initialise + answer, at(0.4), heard);  // the echo, then the answer
  ASSERT_EQ(heard.sent.size(), 3u);
  EXPECT_EQ(heard.sent.back(), poll);
  EXPECT_EQ(driver->deadline(), at(0.9)) << "the rate of the rig: 2 Hz";
  receive(*driver, poll + pressure, at(0.42), heard);
  ASSERT_EQ(heard.all.size(), 1u);
  EXPECT_NEAR(*heard.last<measurement::DepthSample>().pressure_pa, 101'325, 0.01);
  EXPECT_NEAR(*heard.last<measurement::DepthSample>().depth_m, 0, 1e-5);
  EXPECT_EQ(driver->counters().bytes_skipped, 0u);
  driver->tick(at(0.9), heard);
  EXPECT_EQ(heard.sent.back(), poll);
}

TEST(DescribedDrivers, ARecordingIsNeverAnswered) {
  Heard heard;
  const auto driver = driver_of(shipped("keller.toml"));
  driver->set_provenance(measurement::Provenance::replayed);
  driver->restart({}, heard);
  EXPECT_TRUE(heard.sent.empty());
  EXPECT_FALSE(driver->deadline());
}

TEST(DescribedDrivers, NoMessageAllocates) {
  for (const auto& [file, golden] :
       {std::pair("valeport-vat.toml", "valeport-vat.txt"),
        std::pair("water-linked-wrz.toml", "water-linked-wrz.txt"),
        std::pair("keller.toml", "keller.bin"), std::pair("digiquartz.toml", "digiquartz.txt")}) {
    struct Nowhere final : device::Output {
      void publish(const measurement::Measurement&) override { ++count; }
      void send(wire::Bytes) override {}
      void send(const wire::CanFrame&) override {}
      int count = 0;
    } nowhere;
    const auto driver = driver_of(shipped(file));
    const auto stream = wire::testing::fixture(std::string("described/") + golden);
    const device::test::AllocationCount allocations;
    for (int i = 0; i < 100; ++i)
      driver->receive(stream, measurement::stamp_from_ns(i * 1'000'000'000), nowhere);
    EXPECT_EQ(allocations.so_far(), 0u) << file;
    EXPECT_GE(nowhere.count, 100);
  }
}

/// A frozen truth through the emulated device, its line and its driver. The bench is that of a rig:
/// what the driver says reaches the device.
class Bench final : public device::Output {
 public:
  explicit Bench(const std::string& file, double rate_hz = 4)
      : description_(shipped(file)), trajectory_(emulate::under_way()) {
    config_ = emulate::device(description_->kind, file, rate_hz);
    config_.description = description_;
    auto options = options_of(description_);
    options.poll_period = measurement::from_seconds(1 / rate_hz);
    driver_ = std::move(*device::make_byte_driver(options));
  }

  void run(double seconds) {
    emulate::EmulatedLine line(emulate::make_emulated_device(config_, trajectory_, 1).value(),
                               115200, [&](wire::Bytes bytes, const emulate::Passage& passage) {
                                 now_ = passage.ended_at;
                                 driver_->receive(bytes, now_, *this);
                               });
    line_ = &line;
    now_ = emulate::start;
    driver_->restart(now_, *this);
    shell::Lockstep lockstep(emulate::start);
    lockstep.add(line);
    for (double t = 0; t <= seconds; t += 0.01) {
      lockstep.run_until(emulate::at_s(t));
      now_ = emulate::at_s(t);
      if (const auto due = driver_->deadline(); due && *due <= now_) driver_->tick(now_, *this);
    }
    line_ = nullptr;
  }

  void publish(const measurement::Measurement& m) override { all.push_back(m); }
  void send(wire::Bytes bytes) override { line_->receive(bytes, now_); }
  void send(const wire::CanFrame&) override {}
  void report(std::string_view what) override { ADD_FAILURE() << what; }

  std::vector<measurement::Measurement> all;
  const emulate::Frozen& truth() const { return trajectory_; }

 private:
  DescriptionPtr description_;
  emulate::Frozen trajectory_;
  rig_config::DeviceConfig config_;
  std::unique_ptr<device::ByteDriver> driver_;
  emulate::EmulatedLine* line_ = nullptr;
  Stamp now_{};
};

// Under way: 20 m deep, 30 m above the bed, 2 m/s ahead, 0.123 to starboard, -0.045 down.

TEST(DescribedDevices, AnEmulatedValeportGivesTheTruthBack) {
  Bench bench("valeport-vat.toml");
  bench.run(10);
  ASSERT_NEAR(static_cast<double>(bench.all.size()), 41, 1);
  const auto& sample = std::get<measurement::DepthSample>(bench.all.back());
  EXPECT_NEAR(*sample.altitude_m, 30, 0.0005);
  EXPECT_NEAR(*sample.depth_m, 20, 0.2) << "standard gravity, as at sea";
}

TEST(DescribedDevices, AnEmulatedKellerAnswersWhatItsDriverAsks) {
  Bench bench("keller.toml");
  bench.run(10);
  ASSERT_NEAR(static_cast<double>(bench.all.size()), 40, 2);
  EXPECT_NEAR(*std::get<measurement::DepthSample>(bench.all.back()).depth_m, 20, 0.2);
}

TEST(DescribedDevices, AnEmulatedDigiquartzSendsOnceItWasStarted) {
  Bench bench("digiquartz.toml");
  bench.run(10);
  EXPECT_GE(bench.all.size(), 36u);
  EXPECT_NEAR(*std::get<measurement::DepthSample>(bench.all.back()).depth_m, 20, 0.2);
}

TEST(DescribedDevices, EmulatedDvlsGiveTheVelocityOfTheTruthBack) {
  for (const char* file : {"cerulean-dvpdl.toml", "nortek-bt.toml", "water-linked-wrz.toml"}) {
    Bench bench(file, 5);
    bench.run(5);
    ASSERT_GE(bench.all.size(), 24u) << file;
    const auto& sample = std::get<measurement::BottomVelocity>(bench.all.back());
    ASSERT_TRUE(sample.velocity) << file;
    EXPECT_NEAR(sample.velocity->x(), 2, 0.001) << file;
    EXPECT_NEAR(sample.velocity->y(), 0.123, 0.001) << file;
    EXPECT_NEAR(sample.velocity->z(), -0.045, 0.001) << file;
  }
}

TEST(DescribedSurvey, ADescriptionIsFoundOnTheWireThatItDescribes) {
  const auto vat = shipped("valeport-vat.toml");
  survey::ByteSurvey survey({vat, shipped("keller.toml")});
  const auto stream = wire::testing::fixture("described/valeport-vat.txt");
  for (int i = 0; i < 10; ++i) survey.feed(stream, measurement::stamp_from_ns(i * 1'000'000'000));
  const auto best = survey.best();
  EXPECT_EQ(best.protocol, "valeport-vat.toml");
  EXPECT_EQ(best.confidence, survey::Confidence::certain);
  ASSERT_EQ(best.sensors.size(), 1u);
  EXPECT_EQ(best.sensors[0].kind, Kind::depth);
}

}  // namespace
}  // namespace drydock::described::test
