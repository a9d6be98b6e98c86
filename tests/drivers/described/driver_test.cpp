#include <gmock/gmock.h>

#include "drivers/survey/byte_survey.hpp"
#include "rig_config/fault_vocabulary.hpp"
#include "tests/drivers/described/driven.hpp"
#include "tests/drivers/device/allocation_count.hpp"

/// Drivers and emulated devices of descriptions.
namespace drydock::described::test {
namespace {

TEST(DescribedDrivers, TheLineTimeAndTheStatedAgeGiveTheTimeOfValidity) {
  auto options = options_of(shipped("nortek-bt.toml"));
  options.baud = 9600;
  Heard heard;
  const auto driver = *device::make_byte_driver(options);
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

TEST(DescribedDrivers, ADescribedDvlIsPutRightForTheSpeedOfSoundToo) {
  auto options = options_of(shipped("nortek-bt.toml"));
  using Source = device::SoundSpeedOptions::Source;
  options.dvl.sound_speed.source = Source::fixed;
  options.dvl.sound_speed.fixed_mps = 1470;
  options.dvl.sound_speed.set_mps = 1500;
  Heard heard;
  const auto driver = *device::make_byte_driver(options);
  receive(
      *driver,
      "$PNORBT7,1452244916.7508,1.234,-1.234,0.1234,0.1234,0.1234,12.34,23.45,23.45,23.45,23.45*"
      "39\r\n",
      {}, heard);
  ASSERT_EQ(heard.all.size(), 1u);
  EXPECT_NEAR(heard.last<measurement::BottomVelocity>().velocity->x(), 0.98 * 0.1234, 1e-12);
  EXPECT_NEAR(heard.last<measurement::BottomVelocity>().range_m[0].value(), 0.98 * 23.45, 1e-12);
}

// 7.7 ft are 2.3 m: the sounder says one depth in two sentences.
TEST(DescribedDrivers, ASentenceThatSaysTheSameCountsOnlyWhileTheOtherDoesNotCome) {
  const std::string dbt = "$SDDBT,7.7,f,2.3,M,1.3,F*05\r\n", dpt = "$INDPT,2.2,0.0*47\r\n";
  const auto at_s = [](int s) { return measurement::stamp_from_ns(s * 1'000'000'000LL); };
  Heard heard;
  const auto driver = driver_of(shipped("nmea-depth.toml"));
  receive(*driver, dpt, at_s(1), heard);
  EXPECT_EQ(heard.last<measurement::DepthSample>().altitude_m, 2.2);
  receive(*driver, dbt + dpt, at_s(2), heard);
  receive(*driver, dpt, at_s(4), heard);
  EXPECT_EQ(heard.all.size(), 2u);
  EXPECT_EQ(heard.last<measurement::DepthSample>().altitude_m, 2.3);
  receive(*driver, dpt, at_s(5), heard);
  EXPECT_EQ(heard.all.size(), 3u) << "DBT is 3 s old";
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

constexpr std::string_view shy = R"(
[sensor]
title = "A sensor that can say no"
kind = "depth"
[protocol]
checksum = "none"
[[protocol.sentences]]
id = "$PD"
fields = [{field = "depth_m", unit = "m"}]
[[protocol.sentences]]
id = "$POK"
fields = [{skip = true}]
[[protocol.sentences]]
id = "$PNO"
fields = [{skip = true}]
[[start]]
send = "$PSET,1\r\n"
reply = "POK"
refusal = "PNO"
[[start]]
send = "$PGO,1\r\n"
reply = "POK"
)";

TEST(DescribedDrivers, ARefusedRequestIsToldAndTheNextOneFollows) {
  Heard heard;
  const auto driver = driver_of(described(shy));
  driver->restart({}, heard);
  EXPECT_EQ(heard.sent, (std::vector<std::string>{"$PSET,1\r\n"}));
  receive(*driver, "$PNO,\r\n", {}, heard);
  EXPECT_EQ(heard.sent.back(), "$PGO,1\r\n");
  ASSERT_EQ(heard.reports.size(), 1u);
  EXPECT_EQ(heard.reports[0], "the sensor refuses what the start asks");
  receive(*driver, "$POK,\r\n", {}, heard);
  EXPECT_EQ(driver->deadline(), Stamp{} + std::chrono::seconds{2})
      << "the start is over: only a silence begins it again";
  driver->tick(*driver->deadline(), heard);
  EXPECT_EQ(heard.sent.back(), "$PSET,1\r\n");
}

/// The sensor's manual: UN=3 is bar, UN=1 psi. 36.2594 psi are 250 000 Pa.
TEST(DescribedDrivers, ADigiquartzThatKeepsItsUnitIsARefusalAndNoDepth) {
  Heard heard;
  const auto driver = driver_of(shipped("digiquartz.toml"));
  const auto at = [](double s) { return Stamp{measurement::from_seconds(s)}; };
  driver->restart(at(0), heard);
  receive(*driver, "*00012.50000\r\n", at(0.1), heard);
  EXPECT_TRUE(heard.all.empty()) << "nobody knows yet in which unit";
  receive(*driver, "*0001UN=3\r\n", at(0.2), heard);
  EXPECT_EQ(
      heard.reports,
      (std::vector<std::string>{"the sensor refuses unit 1 and says 3: its values are left out"}));
  EXPECT_EQ(heard.sent.back(), "*0100P4\r\n") << "the next request follows";
  receive(*driver, "*00012.50000\r\n", at(0.3), heard);
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(heard.refusals.back(), heard.reports.back());
  receive(*driver, "*0001UN=1\r\n", at(0.4), heard);
  receive(*driver, "*000136.2594\r\n", at(0.5), heard);
  ASSERT_EQ(heard.all.size(), 1u);
  EXPECT_NEAR(*heard.last<measurement::DepthSample>().pressure_pa, 250'000, 1);
}

TEST(DescribedDrivers, ASensorThatNeverSaysItsUnitIsReportedAndBelieved) {
  Heard heard;
  const auto driver = driver_of(shipped("digiquartz.toml"));
  driver->restart({}, heard);
  for (int i = 0; i < 3; ++i) driver->tick(*driver->deadline(), heard);
  EXPECT_EQ(heard.reports,
            (std::vector<std::string>{"the sensor does not answer what the start asks"}));
  receive(*driver, "*000136.2594\r\n", {}, heard);
  EXPECT_EQ(heard.all.size(), 1u);
}

TEST(DescribedDrivers, ARecordingWithAnotherUnitGivesNoDepthEither) {
  Heard heard;
  const auto driver = driver_of(shipped("digiquartz.toml"));
  driver->set_provenance(measurement::Provenance::replayed);
  driver->restart({}, heard);
  receive(*driver, "*000136.2594\r\n", {}, heard);
  EXPECT_EQ(heard.all.size(), 1u) << "a part of a recording may begin behind the reply";
  receive(*driver, "*0001UN=3\r\n*00012.50000\r\n", {}, heard);
  EXPECT_EQ(heard.all.size(), 1u);
  EXPECT_EQ(heard.refusals.size(), 1u);
}

/// Error 32 of the KELLER protocol, 5.1: FA C9 20 and CRC-16/MODBUS, its high byte first.
TEST(DescribedDrivers, AKellerThatLostItsPowerIsInitialisedAtOnce) {
  const std::string initialise("\xFA\x30\x04\x43", 4), poll("\xFA\x49\x01\xA1\xA7", 5);
  const std::string answer("\xFA\x30\x05\x14\x05\x20\x0A\x00\xC3\xC8", 10);
  std::string error("\xFA\xC9\x20", 3);
  unsigned crc = 0xFFFF;
  for (const unsigned char byte : error) {
    crc ^= byte;
    for (int bit = 0; bit < 8; ++bit) crc = crc & 1 ? crc >> 1 ^ 0xA001 : crc >> 1;
  }
  error += {static_cast<char>(crc >> 8), static_cast<char>(crc)};
  Heard heard;
  const auto driver = driver_of(shipped("keller.toml"));
  const auto at = [](double s) { return Stamp{measurement::from_seconds(s)}; };
  driver->restart(at(0), heard);
  receive(*driver, answer, at(0.1), heard);
  receive(*driver, error, at(5), heard);
  EXPECT_EQ(heard.sent.back(), initialise);
  EXPECT_EQ(heard.reports,
            (std::vector<std::string>{
                "the sensor answers a poll with \"error\": the start is said again"}));
  EXPECT_EQ(driver->counters().bytes_skipped, 0u);
  receive(*driver, answer, at(5.1), heard);
  EXPECT_EQ(heard.sent.back(), poll);
  receive(*driver, error, at(5.2), heard);
  EXPECT_EQ(heard.sent.back(), poll) << "not faster than once a second";
}

TEST(DescribedDrivers, ADepthThatNoSeaHasIsRefusedAsAPressureIs) {
  Heard heard;
  const auto driver = driver_of(described(shy));
  for (const char* depth : {"1e30", "-1e30", "12000.1", "-100.1", "-2147483648"})
    receive(*driver, "$PD," + std::string(depth) + "\r\n", {}, heard);
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(heard.refusals.size(), 5u);
  for (const char* depth : {"10902", "-2.5", "0"})  // Challenger Deep; on deck; at the surface
    receive(*driver, "$PD," + std::string(depth) + "\r\n", {}, heard);
  EXPECT_EQ(heard.all.size(), 3u);
}

TEST(DescribedDrivers, AHeightOverTheBedBelowZeroIsRefused) {
  Heard heard;
  const auto driver = driver_of(shipped("nmea-depth.toml"));
  receive(*driver, "$INDPT,-500.0,0.0*6F\r\n", {}, heard);
  EXPECT_TRUE(heard.all.empty());
  EXPECT_EQ(heard.refusals.size(), 1u);
}

TEST(DescribedDevices, AnEmulatedOneRefusesUnderTheFaultNak) {
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(Kind::depth, "shy.toml", 1);
  config.description = described(shy);
  const auto answer = [&](bool refuses) {
    auto condition = std::make_shared<emulate::Condition>();
    if (refuses) condition->troubles.push_back({.kind = rig_config::FaultKind::nak});
    const auto device = emulate::make_emulated_device(config, truth, 1, {truth.start(), condition});
    emulate::Recorder sent;
    const std::string asked = "$PSET,1\r\n";
    (*device)->receive({reinterpret_cast<const std::uint8_t*>(asked.data()), asked.size()},
                       truth.start(), sent);
    const auto bytes = sent.all_bytes();
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_EQ(answer(false), "$POK,\r\n");
  EXPECT_EQ(answer(true), "$PNO,\r\n");
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
      driver->receive(stream, measurement::stamp_from_ns(i * 1'000'000'000LL), nowhere);
    EXPECT_EQ(allocations.so_far(), 0u) << file;
    EXPECT_GE(nowhere.count, 100);
  }
}

// Under way: 20 m deep, 30 m above the bed, 2 m/s ahead, 0.123 to starboard, -0.045 down.

TEST(DescribedDevices, AnEmulatedValeportGivesTheTruthBack) {
  Bench bench("valeport-vat.toml");
  bench.run(10);
  ASSERT_NEAR(static_cast<double>(bench.all.size()), 41, 1);
  const auto& sample = std::get<measurement::DepthSample>(bench.all.back());
  EXPECT_NEAR(*sample.altitude_m, 30, 0.0005);
  EXPECT_NEAR(*sample.depth_m, 20, 0.2) << "standard gravity, as at sea";
}

TEST(DescribedDevices, AnEmulatedSounderOfAnyTalkerGivesTheTruthBack) {
  Bench bench("nmea-depth.toml");
  bench.run(10);
  ASSERT_GE(bench.all.size(), 41u);
  const auto heard = [&](auto member) {
    return std::ranges::any_of(bench.all, [&](const auto& m) {
      const auto& value = std::get<measurement::DepthSample>(m).*member;
      return value && std::abs(*value - 30) < 0.06;  // DBT has a tenth of a metre
    });
  };
  EXPECT_TRUE(heard(&measurement::DepthSample::altitude_m));
  const auto heights = std::ranges::count_if(bench.all, [](const auto& m) {
    return std::get<measurement::DepthSample>(m).altitude_m.has_value();
  });
  EXPECT_NEAR(static_cast<double>(heights), 41, 1) << "one of a ping, though DPT says it again";
}

// 30 m above the bed. NMEA 0183: DBT in feet, metres and fathoms, DPT in metres with the offset of
// the transducer and the range scale.
TEST(DescribedDevices, AnEmulatedSounderSaysTheDepthAsDbtAndAsDpt) {
  const auto sounder = shipped("nmea-depth.toml");
  wire::described::Readings readings;
  readings.set(wire::described::Target::altitude, 30);
  std::string said;
  for (const auto& message : sounder->plan.messages) {
    if (!message.emulated) continue;
    std::array<std::uint8_t, 256> line;
    const auto size = wire::described::encode(sounder->plan, message, readings, line);
    said.append(reinterpret_cast<const char*>(line.data()), size);
  }
  EXPECT_THAT(said, testing::HasSubstr("DBT,98.4,f,30.0,M,16.4,F*"));
  EXPECT_THAT(said, testing::HasSubstr("DPT,30.0,0.0,200*"));
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
  for (int i = 0; i < 10; ++i) survey.feed(stream, measurement::stamp_from_ns(i * 1'000'000'000LL));
  const auto best = survey.best();
  EXPECT_EQ(best.protocol, "valeport-vat.toml");
  EXPECT_EQ(best.confidence, survey::Confidence::certain);
  ASSERT_EQ(best.sensors.size(), 1u);
  EXPECT_EQ(best.sensors[0].kind, Kind::depth);
}

}  // namespace
}  // namespace drydock::described::test
