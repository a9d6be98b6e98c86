#include "drivers/host/page_recorder.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "drivers/recordings/record/recording.hpp"

namespace drydock::host {
namespace page_recorder_test {

using measurement::Stamp;
using nlohmann::json;
using testing::EndsWith;
using testing::HasSubstr;

constexpr auto nine =
    measurement::stamp_from_ns(1'795'251'600'000'000'000);  // 2026-11-21 09:00 UTC

class PageRecorded : public testing::Test {
 protected:
  PageRecorded() {
    rig_.name = "demo rig";
    auto& depth = rig_.devices.emplace_back();
    depth.name = "depth";
    depth.kind = rig_config::DeviceKind::depth;
    depth.protocol = "cia404-pressure";
    depth.link = "can:auto";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// The answer of a service: its JSON, or {"refused": why}.
  json ask(const std::string& name) {
    json answer;
    const auto services = recorder_.services();
    const auto service =
        std::ranges::find(services, "/drydock/recording/" + name, &live::Service::name);
    service->serve("{}", [&](const live::ServiceAnswer& given) {
      if (const auto* why = std::get_if<live::Refused>(&given))
        answer = {{"refused", why->why}};
      else
        answer = json::parse(std::get<std::string>(given));
    });
    return answer;
  }

  void measure(double depth_m) {
    measurement::DepthSample sample;
    sample.origin.valid_at = sample.origin.received_at = nine;
    sample.depth_m = depth_m;
    recorder_.on_measurement(sample);
  }

  static std::size_t messages_in(const std::string& file) {
    auto recording = record::Recording::open(file);
    std::size_t count = 0;
    while (recording.value().next()) ++count;
    return count;
  }

  std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("drydock-page-" + std::to_string(::getpid()));
  rig_config::Rig rig_;
  PageRecorder recorder_{rig_, folder_.string(), [] { return nine; }};
};

TEST_F(PageRecorded, OnlyWhatComesBetweenStartAndStopIsInTheFile) {
  measure(1);
  EXPECT_EQ(ask("state"), json({{"recording", false}}));
  const auto begun = ask("start");
  EXPECT_THAT(begun.value("file", ""), EndsWith("/demo-rig-20261121T090000Z.mcap"));
  EXPECT_EQ(begun["since_s"], 1795251600.0);
  measure(2);
  measure(3);
  const auto ended = ask("stop");
  EXPECT_EQ(ended["recording"], false);
  EXPECT_THAT(ended.value("last", ""), HasSubstr(": 2 messages"));
  measure(4);
  EXPECT_EQ(messages_in(begun["file"]), 2U);
}

TEST_F(PageRecorded, WhatCannotBeDoneIsRefusedWithItsReason) {
  EXPECT_EQ(ask("stop").value("refused", ""), "nothing is recorded");
  const std::string file = ask("start")["file"];
  EXPECT_EQ(ask("start").value("refused", ""), "already recording to " + file);
  measure(1);
  ask("stop");
  EXPECT_THAT(ask("start").value("refused", ""), HasSubstr("exists"));  // within the same second
}

TEST_F(PageRecorded, AFolderThatCannotBeMadeIsNamed) {
  std::ofstream(folder_ / "file") << "x";
  try {
    const PageRecorder recorder(rig_, (folder_ / "file").string(), [] { return nine; });
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("file: cannot make this folder"));
  }
}

}  // namespace page_recorder_test
}  // namespace drydock::host
