#include <fstream>

#include "drivers/wire/dbc/reader.hpp"
#include "tests/drivers/described/dbc_folder.hpp"

/// Messages of a DBC file that no frame tells apart.
namespace drydock::described::test {
namespace dbc_same_frame_test {

class DbcSameFrame : public DbcFolder {};

/// Two depths of messages A and B with these identifiers; 80000000h marks those of 29 bits. Format
/// 3 is J1939.
std::string two_messages(std::uint32_t a, std::uint32_t b, int format) {
  std::string dbc = "VERSION \"\"\nBU_: s\n";
  for (const auto& [name, id] : {std::pair{"A", a}, {"B", b}})
    dbc += "BO_ " + std::to_string(id) + " " + name +
           ": 8 s\n SG_ x : 0|16@1- (0.01,0) [0|0] \"m\" V\n";
  dbc +=
      "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"ExtendedCAN\",\"reserved\","
      "\"J1939PG\";\nBA_DEF_DEF_ \"VFrameFormat\" \"StandardCAN\";\n";
  for (const std::uint32_t id : {a, b})
    dbc += "BA_ \"VFrameFormat\" BO_ " + std::to_string(id) + " " + std::to_string(format) + ";\n";
  return dbc;
}

TEST_F(DbcSameFrame, TwoMessagesThatNoFrameTellsApartAreRefusedAndTheDbcFileIsWarnedOf) {
  struct Case {
    std::uint32_t a, b;
    int format;
    bool is_refused;
  };
  const Case cases[] = {
      {100, 100, 0, true},
      {100, 101, 0, false},
      {100, 0x80000064, 0, false},         // 11 and 29 bits
      {0x98FF0023, 0x8CFF0023, 3, true},   // J1939: another priority
      {0x98FF00FE, 0x8CFF00FE, 3, true},   // of any sender
      {0x98FF0023, 0x98FF0024, 3, false},  // another sender
      {0x98FF00FE, 0x98FF0024, 3, false},  // any, and one of its own
      {0x98EF1023, 0x98EF1123, 3, false},  // another destination
      {0x98EF10FE, 0x98EF11FE, 3, true},   // of any sender a destination tells nothing
      {0x98FF0023, 0x8CFF0023, 0, false},  // not J1939: identifiers of their own
  };
  for (const Case& one : cases) {
    const std::string dbc = two_messages(one.a, one.b, one.format);
    std::ofstream(folder() / "s.dbc") << dbc;
    std::ofstream(folder() / "s.toml") << R"([sensor]
title = "s"
kind = "depth"
[protocol]
dbc = "s.dbc"
[[protocol.frames]]
message = "A"
fields = [{ signal = "x", field = "depth_m" }]
[[protocol.frames]]
message = "B"
fields = [{ signal = "x", field = "altitude_m" }]
)";
    const auto loaded = rig_config::load_description((folder() / "s.toml").string());
    EXPECT_EQ(!loaded, one.is_refused) << std::hex << one.a << " " << one.b;
    if (!loaded) {
      EXPECT_NE(to_string(loaded.error().front())
                    .find("s.toml:10:11: /protocol/frames/1/message: the DBC file gives B the "
                          "identifier of A of line 6: no frame tells which of them it is"),
                std::string::npos)
          << to_string(loaded.error().front());
    }
    const auto reading = wire::dbc::read(dbc);
    EXPECT_EQ(reading.warnings.size(), one.is_refused ? 1u : 0u);
    if (!reading.warnings.empty()) {
      EXPECT_EQ(reading.warnings[0].text,
                one.a == one.b ? "a second message has this identifier; the first one holds"
                               : "message B has the same frames as A of line 3: none tells them "
                                 "apart");
    }
  }
}

}  // namespace dbc_same_frame_test
}  // namespace drydock::described::test
