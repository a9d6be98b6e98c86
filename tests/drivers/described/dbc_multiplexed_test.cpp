#include <fstream>

#include "tests/drivers/described/dbc_folder.hpp"

/// Samples of messages that say their values in turn.
namespace drydock::described::test {
namespace dbc_multiplexed_test {

using measurement::DepthSample;

class DbcMultiplexed : public DbcFolder {};

TEST_F(DbcMultiplexed, AnOptionalPageOfAMultiplexedMessageComesWithTheNextSample) {
  Bus bus(description("depth", R"(BO_ 256 X: 5 s
 SG_ page M : 0|8@1+ (1,0) [0|0] "" V
 SG_ press m0 : 8|32@1+ (1,0) [0|0] "Pa" V
 SG_ temp m1 : 8|32@1+ (0.01,0) [0|0] "K" V
)",
                      R"([[protocol.frames]]
message = "X"
fields = [
 { signal = "press", field = "pressure_pa" },
 { signal = "temp", field = "temperature_k", optional = true },
]
)"));
  for (int i = 0; i < 20; ++i) {
    bus.says(frame("100#00400D0300"), 1 + i * 0.05);       // 200000 Pa
    bus.says(frame("100#01606D0000"), 1.0004 + i * 0.05);  // 280 K
  }
  EXPECT_EQ(bus.all.size(), 20u);
  EXPECT_TRUE(bus.refusals.empty());
  EXPECT_NEAR(*bus.last<DepthSample>().temperature_k, 280, 1e-9);
}

/// Heading, and roll and pitch, one frame each 20 ms: `attributes` may say so.
std::string pages(const std::string& attributes) {
  return R"(BO_ 256 X: 5 s
 SG_ page M : 0|8@1+ (1,0) [0|0] "" V
 SG_ heading m0 : 8|16@1+ (0.01,0) [0|0] "deg" V
 SG_ roll m1 : 8|16@1- (0.01,0) [0|0] "deg" V
 SG_ pitch m1 : 24|16@1- (0.01,0) [0|0] "deg" V
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;
BA_DEF_DEF_ "GenMsgCycleTime" 0;
)" + attributes;
}

constexpr const char* attitude_of_pages = R"([[protocol.frames]]
message = "X"
fields = [
 { signal = "heading", field = "heading_deg" },
 { signal = "roll", field = "roll_deg" },
 { signal = "pitch", field = "pitch_deg" },
]
)";

constexpr const char* each_20_ms = "BA_ \"GenMsgCycleTime\" BO_ 256 20;\n";

TEST_F(DbcMultiplexed, TheHalvesOfAMultiplexedMessageComeACycleApart) {
  for (const std::string attributes : {each_20_ms, ""}) {
    Bus bus(description("attitude", pages(attributes), attitude_of_pages));
    for (int i = 0; i < 50; ++i) {
      bus.says(frame("100#00A00F0000"), 1 + i * 0.04);     // 40 deg
      bus.says(frame("100#0164009CFF"), 1.02 + i * 0.04);  // 1 and -1 deg
    }
    ASSERT_EQ(bus.all.size(), 50u) << attributes;
    EXPECT_TRUE(bus.refusals.empty());
    const auto& last = bus.last<measurement::AttitudeSample>();
    EXPECT_NEAR(*last.true_heading_rad, 40 * emulate::degree, 1e-9);
    EXPECT_NEAR(*last.roll_rad, emulate::degree, 1e-9);
    EXPECT_NEAR(*last.pitch_rad, -emulate::degree, 1e-9);
  }
}

TEST_F(DbcMultiplexed, AHalfThatIsLostCostsNoOtherSampleThanItsOwnAndTheNext) {
  Bus bus(description("attitude", pages(each_20_ms), attitude_of_pages));
  for (int i = 0; i < 50; ++i) {
    if (i != 20) bus.says(frame("100#00A00F0000"), 1 + i * 0.04);
    if (i != 30) bus.says(frame("100#0164009CFF"), 1.02 + i * 0.04);
  }
  EXPECT_GE(bus.all.size(), 48u);
  EXPECT_LE(bus.refusals.size(), 2u);
}

TEST_F(DbcMultiplexed, TheEmulatedSensorSendsOneSelectionEachCycleTime) {
  const auto made = description("attitude", pages(each_20_ms), attitude_of_pages);
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(made->kind.value(), made->name, 25);
  config.description = made;
  std::vector<std::pair<int, Stamp>> heard;
  Bus bus(made);
  emulate::EmulatedBus line(
      500'000, [&](const wire::CanFrame& one, std::size_t, const emulate::Passage& passage) {
        heard.emplace_back(one.data[0], passage.ended_at);
        bus.driver->receive(one, passage.ended_at, bus);
      });
  line.add(emulate::make_emulated_device(config, truth, 1).value());
  shell::Lockstep lockstep(emulate::start);
  lockstep.add(line);
  lockstep.run_until(emulate::at_s(1.99));
  ASSERT_EQ(heard.size(), 100u);
  for (std::size_t i = 1; i < heard.size(); ++i) {
    EXPECT_EQ(heard[i].first, static_cast<int>(i % 2));
    EXPECT_NEAR(measurement::seconds(heard[i].second - heard[i - 1].second), 0.02, 1e-4);
  }
  EXPECT_EQ(bus.all.size(), 50u);
}

TEST_F(DbcMultiplexed, AMessageThatSaysAllAtOnceCannotJoinOneThatSaysItInTurn) {
  const auto problems = [&](int cycle_ms) {
    std::ofstream(folder() / "s.dbc") << "VERSION \"\"\nBU_: s\n"
                                      << R"(BO_ 257 R: 2 s
 SG_ rate : 0|16@1- (0.01,0) [0|0] "deg/s" V
)" << pages(each_20_ms) << "BA_ \"GenMsgCycleTime\" BO_ 257 "
                                      << cycle_ms << ";\n";
    std::ofstream(folder() / "s.toml")
        << "[sensor]\ntitle = \"s\"\nkind = \"attitude\"\n[protocol]\ndbc = \"s.dbc\"\n"
        << attitude_of_pages << R"([[protocol.frames]]
message = "R"
fields = [{ signal = "rate", field = "rate_of_turn_degps" }]
)";
    const auto loaded = rig_config::load_description((folder() / "s.toml").string());
    return loaded ? "" : to_string(loaded.error().front());
  };
  EXPECT_EQ(problems(40), "");
  EXPECT_NE(problems(20).find("its cycle time is 20 ms, and that of line 6 is 40 ms"),
            std::string::npos)
      << problems(20);
}

}  // namespace dbc_multiplexed_test
}  // namespace drydock::described::test
