#include "rig_config/fault_vocabulary.hpp"
#include "tests/drivers/described/driven.hpp"

/// What a described driver asks its sensor at the start and in polls, and how it takes the answers.
namespace drydock::described::test {
namespace dialogue_test {

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

/// A request of MediaTek's receivers, whose checksum is 31: $PMTK605*31.
TEST(DescribedDrivers, TheChecksumIsPutBehindARequestThatAsksForIt) {
  const std::string sentences =
      "[sensor]\ntitle = \"t\"\nkind = \"depth\"\n[protocol]\nchecksum = \"xor\"\n"
      "[[protocol.sentences]]\nid = \"$PD\"\nfields = [{field = \"depth_m\", unit = \"m\"}]\n"
      "[[start]]\nsend = \"$PMTK605\"\nchecksum = true\n";
  Heard heard;
  driver_of(described(sentences))->restart(Stamp{}, heard);
  EXPECT_EQ(heard.sent, (std::vector<std::string>{"$PMTK605*31\r\n"}));
  std::string bare = sentences;
  bare.replace(bare.find("xor"), 3, "none");
  EXPECT_EQ(problems_of(bare), "toy.toml:11:12: /start/0/checksum: the protocol has no checksum\n");
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

/// What the start wants to hear; with `emulate = 3` it refuses, as a sensor may that was set
/// otherwise.
TEST(DescribedDevices, AnEmulatedOneSaysWhatTheStartWantsToHear) {
  const auto answer = [](const std::string& emulate) {
    const emulate::Frozen truth(emulate::under_way());
    auto config = emulate::device(Kind::depth, "set.toml", 1);
    config.description = described(
        "[sensor]\ntitle = \"x\"\nkind = \"depth\"\n[protocol]\n"
        "checksum = \"none\"\n[[protocol.sentences]]\nid = \"$PD\"\n"
        "fields = [{field = \"depth_m\", unit = \"m\"}]\n"
        "[[protocol.sentences]]\nid = \"$POK\"\n"
        "fields = [{name = \"mode\", decimals = 0" +
        emulate +
        "}]\n[[start]]\n"
        "send = \"$PSET\\r\\n\"\nreply = \"POK\"\nsays = {mode = 2}\n");
    const auto device = emulate::make_emulated_device(config, truth, 1, {truth.start(), nullptr});
    emulate::Recorder sent;
    const std::string asked = "$PSET\r\n";
    (*device)->receive({reinterpret_cast<const std::uint8_t*>(asked.data()), asked.size()},
                       truth.start(), sent);
    const auto bytes = sent.all_bytes();
    return std::string(bytes.begin(), bytes.end());
  };
  EXPECT_EQ(answer(""), "$POK,2\r\n");
  EXPECT_EQ(answer(", emulate = 3"), "$POK,3\r\n");
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

TEST(DescribedDrivers, ARecordingIsNeverAnswered) {
  Heard heard;
  const auto driver = driver_of(shipped("keller.toml"));
  driver->set_provenance(measurement::Provenance::replayed);
  driver->restart({}, heard);
  EXPECT_TRUE(heard.sent.empty());
  EXPECT_FALSE(driver->deadline());
}

}  // namespace dialogue_test
}  // namespace drydock::described::test
