#include "tests/drivers/device/support.hpp"

/// The lines of both sides are written by hand from Water Linked's description of its commands.
namespace drydock::device::test {
namespace water_linked_json_dialogue_test {

using namespace std::chrono_literals;
using measurement::BottomVelocity;

const Octets usual = octets(
    "{\"time\":83.4,\"vx\":1.234,\"vy\":-0.056,\"vz\":0.078,\"fom\":0.003,"
    "\"covariance\":[[1,0,0],[0,1,0],[0,0,1]],\"altitude\":6.98,\"velocity_valid\":true,"
    "\"status\":0,\"transducers\":[],\"format\":\"json_v3.3\",\"type\":\"velocity\","
    "\"time_of_validity\":1795262400123456,\"time_of_transmission\":1795262400198456}\r\n");

DriverOptions tcp() { return options(Kind::dvl, "water-linked-json"); }

class JsonDialogue : public testing::Test {
 protected:
  void open(const std::optional<WaterLinkedSettings>& wanted) {
    DriverOptions o = tcp();
    o.dvl.water_linked = wanted;
    driver_ = byte_driver(o);
    driver_->restart(now_, ear_);
  }
  std::string asked() const {
    if (ear_.sent_bytes.empty()) return "";
    return {ear_.sent_bytes.back().begin(), ear_.sent_bytes.back().end()};
  }
  void answer(const std::string& to, const std::string& result, bool success = true,
              const std::string& error = "") {
    hear(octets("{\"response_to\":\"" + to + "\",\"success\":" + (success ? "true" : "false") +
                ",\"error_message\":\"" + error + "\",\"result\":" + result +
                ",\"format\":\"json_v3.3\",\"type\":\"response\"}\r\n"));
  }
  void hear(const Octets& bytes) { driver_->receive(bytes, now_ += 10ms, ear_); }
  bool gives_velocity() {
    ear_.heard.clear();
    hear(usual);
    return ear_.all<BottomVelocity>().at(0).velocity.has_value();
  }
  void wait_for_deadline() {
    ASSERT_TRUE(driver_->deadline());
    now_ = *driver_->deadline();
    driver_->tick(now_, ear_);
  }

  Ear ear_;
  Stamp now_ = at_s(1);
  std::unique_ptr<ByteDriver> driver_;
};

WaterLinkedSettings all_settings() {
  WaterLinkedSettings wanted{1490.0, 45 * degree};
  wanted.range_mode = "1<=3";
  wanted.acoustic_enabled = true;
  return wanted;
}

const std::string set_all =
    "{\"command\":\"set_config\",\"parameters\":{\"speed_of_sound\":1490,"
    "\"acoustic_enabled\":true,\"mounting_rotation_offset\":45,\"range_mode\":\"1<=3\"}}\r\n";
const std::string read_back = "{\"command\":\"get_config\"}\r\n";

std::string values(const char* sound, const char* rotation, const char* acoustic = "true") {
  return std::string("{\"speed_of_sound\":") + sound + ",\"acoustic_enabled\":" + acoustic +
         ",\"dark_mode_enabled\":false,\"mounting_rotation_offset\":" + rotation +
         ",\"range_mode\":\"1<=3\",\"periodic_cycling_enabled\":true}";
}

TEST_F(JsonDialogue, SetsReadsBackAndThenBelievesTheVelocities) {
  open(all_settings());
  EXPECT_EQ(asked(), set_all);
  EXPECT_FALSE(gives_velocity()) << "not confirmed yet";
  answer("set_config", "null");
  EXPECT_EQ(asked(), read_back);
  answer("get_config", values("1490", "45"));
  EXPECT_TRUE(gives_velocity());
  EXPECT_EQ(ear_.sent_bytes.size(), 2U);
  EXPECT_FALSE(driver_->deadline());
  EXPECT_TRUE(ear_.reports.empty());
}

TEST_F(JsonDialogue, WithoutSettingsTheDriverOnlyListens) {
  open(std::nullopt);
  EXPECT_EQ(asked(), "");
  EXPECT_FALSE(driver_->deadline());
  EXPECT_TRUE(gives_velocity());
}

TEST_F(JsonDialogue, AnEmptyTableOnlyReads) {
  open(WaterLinkedSettings{});
  EXPECT_EQ(asked(), read_back);
  answer("get_config", values("1475", "0"));
  EXPECT_TRUE(ear_.reports.empty());
  EXPECT_TRUE(gives_velocity());
}

TEST_F(JsonDialogue, ARefusalIsReportedWithItsReason) {
  open(all_settings());
  answer("set_config", "null", false, "Out of range");
  EXPECT_EQ(ear_.reports, std::vector<std::string>{"the DVL refuses set_config: Out of range"});
  EXPECT_EQ(asked(), read_back);
}

TEST_F(JsonDialogue, ValuesThatDoNotHoldAreReportedAndVelocitiesLeftOut) {
  open(all_settings());
  answer("set_config", "null");
  answer("get_config", values("1500.25", "0", "false"));
  EXPECT_EQ(ear_.reports,
            (std::vector<std::string>{
                "the DVL uses a speed of sound of 1500.25 m/s, not the one of the rig file",
                "the DVL turns its velocities by 0.00 degrees, not by the mounting_rotation_deg of "
                "the rig file",
                "the DVL's acoustics are switched off",
                "the DVL refuses set_config: it says that it took it, and keeps other values"}));
  EXPECT_FALSE(gives_velocity());
}

TEST_F(JsonDialogue, ARefusalIsTheLastWordAlsoWhenTheValuesDiffer) {
  open(all_settings());
  answer("set_config", "null", false, "Out of range");
  answer("get_config", values("1475", "0"));
  EXPECT_EQ(ear_.reports.back(), "the DVL refuses set_config: Out of range");
  EXPECT_FALSE(gives_velocity());
}

TEST_F(JsonDialogue, ASlowAnswerCountsThoughTheDriverHasGivenUp) {
  open(all_settings());
  answer("set_config", "null");
  for (int i = 0; i < 3; ++i) hear(usual), wait_for_deadline();
  EXPECT_TRUE(gives_velocity()) << "not verified, which is reported";
  EXPECT_EQ(ear_.reports.back(), "no answer to get_config");
  answer("get_config", values("1475", "45"));
  EXPECT_FALSE(gives_velocity()) << "the answer came at last, and differs";
}

TEST_F(JsonDialogue, TheSpeedOfSoundThatWasReadBackCorrectsTheVelocity) {
  DriverOptions o = tcp();
  o.dvl.water_linked = WaterLinkedSettings{1480.0, {}};
  o.dvl.sound_speed.source = SoundSpeedOptions::Source::fixed;
  o.dvl.sound_speed.fixed_mps = 1500;
  o.dvl.sound_speed.set_mps = 1475;  // of an older rig file: what the DVL says counts
  driver_ = byte_driver(o);
  driver_->restart(now_, ear_);
  answer("set_config", "null");
  answer("get_config", values("1480", "0"));
  ear_.heard.clear();
  hear(usual);
  const auto sample = ear_.all<BottomVelocity>().at(0);
  EXPECT_NEAR(sample.velocity->x(), 1.234 * 1500 / 1480, 1e-12);
  ASSERT_TRUE(sample.velocity_covariance);
  EXPECT_NEAR((*sample.velocity_covariance)(0, 0), 1500.0 / 1480 * 1500 / 1480, 1e-12);
  EXPECT_NEAR(*sample.figure_of_merit_mps, 0.003 * 1500 / 1480, 1e-12);
  EXPECT_EQ(sample.sound_speed_mps, 1500);
}

TEST_F(JsonDialogue, AnAnswerToAnotherClientsCommandIsNotItsOwn) {
  open(all_settings());
  answer("reset_dead_reckoning", "null");
  EXPECT_EQ(ear_.sent_bytes.size(), 1U);
}

TEST_F(JsonDialogue, ThreeTimesInAllThenAgainAfterHalfAMinute) {
  open(all_settings());
  for (int i = 0; i < 3; ++i) wait_for_deadline();
  EXPECT_EQ(ear_.sent_bytes.size(), 3U);
  EXPECT_EQ(now_, at_s(4));
  EXPECT_EQ(ear_.reports, std::vector<std::string>{"no answer to set_config"});
  EXPECT_EQ(driver_->deadline(), at_s(34));
  wait_for_deadline();
  EXPECT_EQ(ear_.sent_bytes.size(), 4U);
}

TEST_F(JsonDialogue, ADvlThatWasSilentIsSetUpAgain) {
  open(all_settings());
  answer("set_config", "null");
  answer("get_config", values("1490", "45"));
  hear(usual);
  now_ += 3s;
  hear(usual);
  EXPECT_EQ(ear_.sent_bytes.size(), 3U);
  EXPECT_EQ(asked(), set_all);
}

TEST_F(JsonDialogue, ARecordingIsNotAccusedOfSilence) {
  DriverOptions o = tcp();
  o.dvl.water_linked = all_settings();
  driver_ = byte_driver(o);
  driver_->set_provenance(measurement::Provenance::replayed);
  driver_->restart(now_, ear_);
  for (int i = 0; i < 3; ++i) wait_for_deadline();
  EXPECT_TRUE(ear_.reports.empty());
}

}  // namespace water_linked_json_dialogue_test
}  // namespace drydock::device::test
