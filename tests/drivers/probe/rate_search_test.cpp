#include <gmock/gmock.h>

#include <future>
#include <thread>

#include "drivers/probe/probe_report.hpp"
#include "tests/drivers/link/scripted_adapter.hpp"

/// The probe of an slcan adapter on a bus whose rate nobody has stated.
namespace drydock::probe {
namespace {

using link::testing::Folder;
using link::testing::ScriptedAdapter;
using ::testing::Contains;
using ::testing::HasSubstr;

/// Probes an adapter that follows the script, and returns the report and what the adapter got.
std::pair<ProbeReport, std::string> probe(const std::string& query, ScriptedAdapter::Script script,
                                          double duration_s) {
  const Folder folder;
  const std::string pty = "pty:" + folder.file("can");
  boost::asio::io_context io;
  ScriptedAdapter adapter(io, pty, std::move(script));
  auto found = std::async(std::launch::async,
                          [&] { return find_sensors("slcan:" + pty + query, duration_s); });
  while (found.wait_for(std::chrono::seconds{0}) != std::future_status::ready) {
    io.run_for(std::chrono::milliseconds{10});
    io.restart();
  }
  link::testing::settle(io);
  return {found.get(), adapter.got()};
}

std::string frames(int count) {
  std::string lines;
  for (int i = 0; i < count; ++i) lines += "t1231AA\r";
  return lines;
}

TEST(RateSearch, TheRateWithFramesIsFoundAndTheAdapterOnlyListens) {
  const auto [report, got] = probe("", {{"S4 L", "\r" + frames(3)}}, 3);
  EXPECT_EQ(report.bitrate, 125'000U);
  EXPECT_EQ(report.frames % 3, 0U);  // an adapter that fell silent is opened again
  EXPECT_GT(report.frames, 0U);
  EXPECT_EQ(got.find('O'), std::string::npos);
  EXPECT_TRUE(got.ends_with("\rC\rS4\rL\r\rC\r")) << got;
  EXPECT_THAT(report.notes, Contains(HasSubstr("125000 bit/s")));
}

TEST(RateSearch, WithoutFramesEveryRateIsTriedAndNoChannelIsLeftOpen) {
  const auto [report, got] = probe("", {}, 2);
  EXPECT_EQ(report.frames, 0U);
  EXPECT_EQ(got.find('O'), std::string::npos);
  for (const char* rate : {"S0", "S1", "S2", "S3", "S4", "S5", "S6", "S7", "S8"})
    EXPECT_THAT(got, HasSubstr("\rC\r" + std::string(rate) + "\rL\r\rC\r"));
  EXPECT_THAT(report.notes, Contains(HasSubstr("no frames at any rate")));
}

TEST(RateSearch, AStatedRateIsTheOnlyOneTried) {
  const auto [report, got] = probe("?bitrate=500000", {{"S6 L", "\r" + frames(2)}}, 0.5);
  EXPECT_EQ(got, "\rC\rS6\rL\r\rC\r");
  EXPECT_EQ(report.frames, 2U);
}

TEST(RateSearch, ARateThatTheAdapterLacksIsPassedOver) {
  const auto [report, got] = probe("", {{"S5", "\a"}, {"S7", "\a"}, {"S8 L", "\r" + frames(1)}}, 3);
  EXPECT_EQ(report.bitrate, 1'000'000U);
  EXPECT_EQ(report.frames, 1U);
}

TEST(RateSearch, AnAdapterThatCannotListenIsNotOpened) {
  const auto [report, got] = probe("", {{"L", "\a"}}, 2);
  EXPECT_EQ(got, "\rC\rS5\rL\r\rC\r");
  EXPECT_THAT(report.notes, Contains(HasSubstr("refused L")));
}

}  // namespace
}  // namespace drydock::probe
