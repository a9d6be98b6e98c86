#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/drivers/described/surveyed_buses.hpp"

/// Described sensors under identifiers that are also those of other protocols.
namespace drydock::described::test {
namespace bus_probe_identifiers_test {

using survey::Confidence;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Pair {
  std::uint32_t gyro, accel;
  bool extended = false;
};

/// Identifiers that look like PDOs, SDOs, heartbeats or J1939, the last of them like those of a
/// sender that claimed its address.
class BusProbeOfIdentifiers : public DbcFolder, public testing::WithParamInterface<Pair> {
 protected:
  DescriptionPtr imu() const {
    const auto [gyro, accel, extended] = GetParam();
    const std::uint32_t bit31 = extended ? 0x80000000u : 0;
    const auto message = [bit31](std::uint32_t id, const char* name, const char* unit) {
      std::string text = fmt::format("BO_ {} {}: 8 s\n", id | bit31, name);
      for (int axis = 0; axis < 3; ++axis)
        text += fmt::format(" SG_ {}_{} : {}|16@1- (0.01,0) [0|0] \"{}\" s\n", name, axis,
                            16 * axis, unit);
      return text +
             " SG_ count : 48|8@1+ (1,0) [0|0] \"\" s\n SG_ sum : 56|8@1+ (1,0) [0|0] \"\" s\n";
    };
    const auto frames = [](const char* name, const char* field) {
      return fmt::format(
          "[[protocol.frames]]\nmessage = \"{0}\"\ncounter = {{ signal = \"count\" }}\n"
          "checksum = {{ signal = \"sum\", kind = \"sum\" }}\nfields = [\n"
          "{{ signal = \"{0}_0\", field = \"{1}\" }},\n{{ signal = \"{0}_1\", field = \"{2}\" }},\n"
          "{{ signal = \"{0}_2\", field = \"{3}\" }},\n]\n",
          name, fmt::format(fmt::runtime(field), 'x'), fmt::format(fmt::runtime(field), 'y'),
          fmt::format(fmt::runtime(field), 'z'));
    };
    std::string cycles =
        "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\nBA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n";
    for (const std::uint32_t id : {gyro, accel})
      cycles += fmt::format("BA_ \"GenMsgCycleTime\" BO_ {} 20;\n", id | bit31);
    return description("imu",
                       message(gyro, "gyro", "deg/s") + message(accel, "accel", "m/s2") + cycles,
                       frames("gyro", "rate_{}_degps") + frames("accel", "force_{}_mps2"));
  }
};

TEST_P(BusProbeOfIdentifiers, AreFoundByTheirDescriptionAndAreNoNodes) {
  const auto one = imu();
  const auto nodes = nodes_of(frames_of(one), {one});
  ASSERT_EQ(nodes.size(), 1u) << "no nodes beside it";
  EXPECT_EQ(nodes[0].kind, NodeKind::described);
  EXPECT_EQ(nodes[0].confidence, Confidence::certain);
  ASSERT_THAT(protocols(nodes), testing::ElementsAre("s.toml"));
  EXPECT_NEAR(*nodes[0].sensors[0].rate_hz, 50, 0.5);
  EXPECT_EQ(nodes[0].sensors[0].evidence,
            "2 of 2 messages, 202 frames as long as described, 202 checksums right, counters "
            "without a jump, cycle times as described");
}

TEST_P(BusProbeOfIdentifiers, AreFoundBesideNodesThatAreStillFound) {
  const auto one = imu();
  const auto nodes = nodes_of(frames_of(one) + canopen_node() + nmea2000_node(), {one});
  EXPECT_EQ(nodes.size(), 3u);
  ASSERT_TRUE(node_with(nodes, "s.toml"));
  EXPECT_EQ(node_with(nodes, "s.toml")->confidence, Confidence::certain);
  expect_both_neighbours(nodes);
}

TEST_P(BusProbeOfIdentifiers, AreNotFoundWhereLengthsOrChecksumsAreOthers) {
  const auto one = imu();
  auto shorter = frames_of(one), damaged = shorter;
  for (auto& each : shorter) each.frame.size = 6;
  for (auto& each : damaged) each.frame.data[7] ^= 0x5A;
  EXPECT_THAT(protocols(nodes_of(shorter, {one})), Not(Contains("s.toml")));
  EXPECT_THAT(protocols(nodes_of(damaged, {one})), Not(Contains("s.toml")));
  BusSurvey survey({one});
  for (const auto& [at, sent] : damaged) survey.receive(sent, at);
  ASSERT_EQ(survey.missed().size(), 1u);
  EXPECT_THAT(survey.missed()[0], HasSubstr("202 of 202 checksums wrong"));
}

TEST_P(BusProbeOfIdentifiers, AreFoundInAFewFramesOfWhichOneIsDamaged) {
  const auto one = imu();
  auto few = frames_of(one);
  few.resize(4);
  few.back().frame.data[7] ^= 0x5A;
  const auto nodes = nodes_of(few, {one});
  ASSERT_TRUE(node_with(nodes, "s.toml"));
  EXPECT_EQ(node_with(nodes, "s.toml")->confidence, Confidence::likely);
}

INSTANTIATE_TEST_SUITE_P(
    Frames, BusProbeOfIdentifiers,
    testing::Values(Pair{0x200, 0x201}, Pair{0x201, 0x202}, Pair{0x210, 0x211}, Pair{0x301, 0x302},
                    Pair{0x600, 0x601}, Pair{0x181, 0x281}, Pair{0x081, 0x581}, Pair{0x701, 0x702},
                    Pair{0x064, 0x065}, Pair{0x12345678, 0x12345679, true},
                    Pair{0x18FF0101, 0x0CF02A02, true}, Pair{0x12340134, 0x12350134, true}),
    [](const auto& one) { return fmt::format("{:X}And{:X}", one.param.gyro, one.param.accel); });

class BusProbeOfBoth : public DbcFolder {
 protected:
  /// A pressure where TPDO1 of node 5 is.
  DescriptionPtr pressure() const {
    return description("depth",
                       "BO_ 389 state: 5 s\n SG_ pressure : 0|32@1- (1,0) [0|0] \"Pa\" s\n",
                       "[[protocol.frames]]\nmessage = \"state\"\n"
                       "fields = [{ signal = \"pressure\", field = \"pressure_pa\" }]\n");
  }
  static Frames of(const std::string& data, int count) {
    Frames all;
    for (int i = 0; i < count; ++i) all.push_back({emulate::at_s(0.1 * i), frame(data)});
    return all;
  }
};

TEST_F(BusProbeOfBoth, WithoutAHeartbeatIsADescribedSensorThatCanopenWouldReadToo) {
  const auto nodes = nodes_of(of("185#A086010000", 10), {pressure()});
  ASSERT_EQ(nodes.size(), 1u);
  EXPECT_EQ(nodes[0].kind, NodeKind::described);
  EXPECT_THAT(nodes[0].also,
              testing::UnorderedElementsAre(
                  "cia404-pressure reads 10 measurements of kind depth in the same frames",
                  "CANopen would have them of the nodes 5, of which no heartbeat, boot-up or SDO "
                  "answer was heard"));
}

TEST_F(BusProbeOfBoth, WithAHeartbeatIsADescribedSensorAndANode) {
  const auto nodes = nodes_of(of("185#A086010000", 10) + of("705#05", 10), {pressure()});
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[0].kind, NodeKind::described);
  EXPECT_THAT(nodes[0].also,
              Contains("185h may be of CANopen node 5 too, whose heartbeat was heard"));
  EXPECT_EQ(nodes[1].state, wire::canopen::NodeState::operational);
  EXPECT_THAT(nodes[1].also, Contains("s.toml describes 185h"));
  EXPECT_THAT(nodes[1].sensors, IsEmpty()) << "its frames are those of the description";
}

TEST_F(BusProbeOfBoth, AnswersBySdoProveANode) {
  const auto nodes =
      nodes_of(of("185#A086010000", 10) + of("585#4300100094010200", 1), {pressure()});
  ASSERT_EQ(nodes.size(), 2u);
  EXPECT_EQ(nodes[1].device_type, 0x00020194u);
}

TEST_F(BusProbeOfBoth, ADescriptionOfAnotherSensorSaysThatItDidNotCome) {
  BusSurvey survey({shipped("xsens-dbc.toml"), shipped("keller.toml")});
  for (const auto& [at, one] : canopen_node()) survey.receive(one, at);
  EXPECT_THAT(survey.missed(),
              testing::ElementsAre("xsens-dbc.toml is not on this bus: 0 of 5 messages"));
}

}  // namespace bus_probe_identifiers_test
}  // namespace drydock::described::test
