#include <gmock/gmock.h>

#include <cstdio>
#include <memory>

#include "drivers/probe/probe.hpp"
#include "drivers/probe/probe_report.hpp"

/// What a probe calls wrong, and its exit code.
namespace drydock::probe {
namespace problems_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

ProbeReport heard(std::uint64_t good, std::uint64_t bad) {
  survey::ByteFinding finding;
  finding.protocol = "pd0";
  finding.confidence = survey::Confidence::likely;
  finding.proofs = good;
  finding.bad_checksums = bad;
  ProbeReport report;
  report.attempts.push_back({"9600 8N1", "serial:x?baud=9600", 100, {finding}});
  return report;
}

TEST(Problems, OfALineAreSilenceAndMoreThanOneDamagedFrameInTen) {
  EXPECT_THAT(problems_of({}), ElementsAre("nothing was found"));
  EXPECT_THAT(problems_of(heard(90, 10)), IsEmpty());
  EXPECT_THAT(problems_of(heard(88, 12)), ElementsAre("12 of 100 frames of pd0 are damaged"));
  EXPECT_THAT(problems_of(heard(6, 1)), IsEmpty());  // listening began inside it
}

TEST(Problems, OfABusAreErrorFramesAndEmergenciesThatLast) {
  survey::Node node;
  node.kind = survey::NodeKind::canopen;
  node.address = 36;
  node.frames = 5;
  node.emergency.emplace();
  ProbeReport report;
  report.nodes = {node};
  EXPECT_THAT(problems_of(report), IsEmpty());  // code 0: the error is over, CiA 301
  report.nodes[0].emergency->code = 0x8110;
  report.complaints = {{"bus error", 12}};
  const auto problems = problems_of(report);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0], "12 error frames: bus error");
  EXPECT_THAT(problems[1], HasSubstr("CANopen node 36: emergency 8110h"));
}

TEST(Problems, OfALinkThatCannotBeOpenedStandInTheJson) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out{std::tmpfile(), std::fclose},
      err{std::tmpfile(), std::fclose};
  EXPECT_EQ(
      probe({.link = "serial:/dev/nowhere", .duration_s = 1, .json = true}, out.get(), err.get()),
      1);
  std::string text(static_cast<std::size_t>(std::ftell(out.get())), '\0');
  std::rewind(out.get());
  ASSERT_EQ(std::fread(text.data(), 1, text.size(), out.get()), text.size());
  EXPECT_THAT(text, HasSubstr("\"problems\""));
  EXPECT_THAT(text, HasSubstr("No such file or directory"));
}

}  // namespace problems_test
}  // namespace drydock::probe
