#include <gtest/gtest.h>

#include "drivers/process/child.hpp"
#include "tests/hil/emulate/canopen_master.hpp"
#include "tests/npm/node.hpp"

/// A master of another maker against our nodes: the package `canopen` of npm, which reads our
/// electronic data sheets, speaks SDO, NMT and PDO, and knows nothing of us.
namespace drydock::emulate {
namespace canopen_npm_test {

using nlohmann::json;
using rig_config::DeviceKind;

/// What the master says at its end. The bus stands still while the master thinks.
json let_master(const std::string& task, const std::string& sheet, DeviceKind kind) {
  Master node(device(kind, sheet, 10));
  process::Child master(
      test::node_command("tests/npm/canopen_master.cjs",
                         {DRYDOCK_SOURCE_DIR "/rig_config/eds/" + sheet + ".eds", task}),
      "");
  double now_s = 0;
  const auto pass_on = [&] {
    for (const auto& sent : node.sent.frames) master.send(text_of(sent.frame));
    node.sent.frames.clear();
  };
  while (const auto line = master.line(std::chrono::seconds{30})) {
    if (line->starts_with("end ")) return json::parse(line->substr(4), nullptr, false);
    if (*line == "wait") {
      now_s += 0.95;
      node.sent.run(*node.node, at_s(now_s));
      pass_on();
      master.send("waited");
    } else {
      node.hear(frame(std::string(*line)));
      pass_on();
    }
  }
  return master.ended();
}

class CanopenOfNpm : public testing::Test {
 protected:
  void SetUp() override { DRYDOCK_NEEDS_NODE(); }
};

TEST_F(CanopenOfNpm, ReadsEveryObjectOfOurSheetsAsTheyHaveIt) {
  constexpr std::array<std::tuple<const char*, DeviceKind, std::size_t>, 5> sheets{
      {{"cia404-imu", DeviceKind::imu, 57},
       {"cia404-pressure", DeviceKind::depth, 33},
       {"epson-g550", DeviceKind::imu, 57},
       {"epson-g552", DeviceKind::imu, 57},
       {"cia402", DeviceKind::actuator, 43}}};
  for (const auto& [sheet, kind, at_least] : sheets) {
    const auto all = let_master("read", sheet, kind);
    ASSERT_TRUE(all.is_object()) << sheet << ": " << all;
    std::size_t same = 0;
    for (const auto& [entry, values] : all.items()) {
      const bool measured = entry > "2000" || entry == "1018:4";
      const bool of_node = entry == "1014:0" || (entry.size() == 6 && entry.ends_with(":1") &&
                                                 (entry[1] == '4' || entry[1] == '8'));
      if (entry == "1003:0" || entry.starts_with("1600:0") ||
          (entry.starts_with("1a") && entry.ends_with(":0")))
        continue;  // this reader counts the sub-indexes
      if (entry == "1003:1") {
        EXPECT_EQ(values[0], "refused 8000024");
      } else if (of_node) {  // $NODEID, which this reader does not know
        EXPECT_EQ(values[0].get<unsigned>() & 0x7F, 1U) << entry;
      } else if (measured) {
        EXPECT_TRUE(values[0].is_number() || values[0].is_null()) << sheet << entry << values;
      } else {
        EXPECT_EQ(values[0], values[1]) << sheet << " " << entry;
        ++same;
      }
    }
    EXPECT_GE(same, at_least) << sheet;
  }
}

TEST_F(CanopenOfNpm, MapsAPdoAnewAndReceivesIt) {
  const auto done = let_master("remap", "cia404-pressure", DeviceKind::depth);
  const json written = "written";
  EXPECT_EQ(done["answers"],
            json::array({written, written, written, written, "refused 6040041", written, written}))
      << done;
  EXPECT_GE(done["received"], 1);
  EXPECT_EQ(done["status"], 0);
  EXPECT_NEAR(done["value"].get<double>(), 101325 + 1025 * 9.81 * 20, 2000);
  EXPECT_EQ(done["value"], done["read"]);
}

TEST_F(CanopenOfNpm, IsRefusedWithTheCodesOfTheStandard) {
  const auto done = let_master("provoke", "cia404-pressure", DeviceKind::depth);
  const json wanted{{"object", "refused 6020000"},    {"subindex", "refused 6090011"},
                    {"readOnly", "refused 6010002"},  {"length", "refused 6070010"},
                    {"signature", "refused 8000020"}, {"saved", "written"},
                    {"blocks", "refused 5040001"},    {"long", "refused 6070012"}};
  EXPECT_EQ(done, wanted);
}

}  // namespace canopen_npm_test
}  // namespace drydock::emulate
