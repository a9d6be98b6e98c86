// The commands that `drydock doctor` advises are run, and mend what it found.
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/vcan/process.hpp"

namespace drydock::ports {
namespace {

using nlohmann::json;

std::string rig_on(const std::string& link) {
  const std::string path = ::testing::TempDir() + "doctored.toml";
  std::ofstream(path)
      << "[rig]\nname = \"doctored\"\npublish = false\n\n[[device]]\nname = \"depth\"\n"
         "kind = \"depth\"\nprotocol = \"nmea2000\"\nlink = \""
      << link << "\"\nrate_hz = 10\n";
  return path;
}

/// What is not ok.
std::vector<json> found_by_doctor(const std::string& rig) {
  vcan::Process doctor({DRYDOCK_PROGRAM, "doctor", rig, "--json"});
  const auto report = json::parse(doctor.output_until("}]}"));
  std::vector<json> found;
  for (const auto& check : report.at("checks"))
    if (check.at("fitness") != "ok") found.push_back(check);
  return found;
}

/// Runs the commands advised for what the text names; the machine has no sudo, and its user is
/// root.
void run_advice(const std::vector<json>& found, const std::string& about) {
  for (const auto& one : found) {
    std::string command = one.at("command");
    for (auto at = command.find("sudo "); at != command.npos; at = command.find("sudo "))
      command.erase(at, 5);
    if (one.at("text").get<std::string>().find(about) == std::string::npos) continue;
    EXPECT_EQ(vcan::run_program({"sh", "-c", command}), 0) << command;
  }
}

bool tells(const std::vector<json>& found, const std::string& text) {
  for (const auto& one : found)
    if (one.at("text").get<std::string>().find(text) != std::string::npos) return true;
  return false;
}

TEST(Doctor, AnInterfaceThatIsDownOrAtAnotherRateIsSetUpByTheAdvisedCommand) {
  const std::string rig = rig_on("socketcan:can0?bitrate=250000");
  ASSERT_TRUE(tells(found_by_doctor(rig), "can0 is down"));
  ASSERT_EQ(
      vcan::run_program({"ip", "link", "set", "can0", "up", "type", "can", "bitrate", "500000"}),
      0);
  const auto wrong = found_by_doctor(rig);
  ASSERT_TRUE(tells(wrong, "can0 runs at 500000 bit/s, the rig says 250000"));
  run_advice(wrong, "can0 runs at");
  EXPECT_FALSE(tells(found_by_doctor(rig), "can0 runs at"));
  EXPECT_FALSE(tells(found_by_doctor(rig), "can0 is down"));
}

TEST(Doctor, AShortSendQueueIsLengthenedByTheAdvisedCommand) {
  const std::string rig = rig_on("socketcan:can0?bitrate=250000");
  const auto found = found_by_doctor(rig);
  ASSERT_TRUE(tells(found, "can0 queues 10 frames"));
  run_advice(found, "can0 queues");
  EXPECT_FALSE(tells(found_by_doctor(rig), "can0 queues"));
}

TEST(Doctor, AnAdaptersLatencyTimerIsSetByTheAdvisedCommand) {
  const std::string path = ::testing::TempDir() + "latency.toml";
  std::ofstream(path)
      << "[rig]\nname = \"latency\"\npublish = false\n\n[[device]]\nname = \"log\"\nkind = "
         "\"emlog\"\n"
         "protocol = \"nmea0183\"\nlink = \"serial:/dev/ttyUSB0?baud=4800\"\nrate_hz = 1\n";
  ASSERT_EQ(vcan::run_program(
                {"sh", "-c", "echo 16 > /sys/bus/usb-serial/devices/ttyUSB0/latency_timer"}),
            0);
  const auto found = found_by_doctor(path);
  ASSERT_TRUE(tells(found, "keeps bytes for up to 16 ms"));
  run_advice(found, "keeps bytes for");
  EXPECT_FALSE(tells(found_by_doctor(path), "keeps bytes for"));
}

}  // namespace
}  // namespace drydock::ports
