#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/wire/protocols.hpp"
#include "tests/drivers/described/surveyed_buses.hpp"

/// Described sensors that the program contains, on buses that nobody knows, alone and beside nodes
/// of CANopen and NMEA 2000.
namespace drydock::described::test {
namespace bus_probe_test {

using survey::Confidence;
using testing::Contains;

TEST(BusProbe, EachShippedDescriptionOfFramesIsFoundAloneAndBesideOtherNodes) {
  int tried = 0;
  for (const auto& one : rig_config::shipped_descriptions()) {
    if (!one->frames) continue;
    ++tried;
    const auto alone = nodes_of(frames_of(one), {one});
    EXPECT_THAT(protocols(alone), Contains(one->name));
    const auto nodes = nodes_of(frames_of(one) + canopen_node() + nmea2000_node(), {one});
    const Node* found = node_with(nodes, one->name);
    ASSERT_TRUE(found) << one->name;
    EXPECT_EQ(found->confidence, Confidence::certain) << one->name;
    EXPECT_GE(found->sensors[0].measurements, 80u) << "50 Hz for 2 s, less 250 ms for an address";
    expect_both_neighbours(nodes);
  }
  EXPECT_EQ(tried, 3);
}

/// The families of the registry that a shipped description describes too.
bool is_described_by(std::string_view protocol, std::string_view description) {
  constexpr std::pair<std::string_view, std::string_view> same[]{
      {"nmea2000", "n2k-compass-dbc.toml"},
      {"microstrain-mv5", "mv5-dbc.toml"},
      {"aceinna", "mv5-dbc.toml"},  // the same groups of J1939, in other axes
      {"xsens", "xsens-dbc.toml"}};
  return std::ranges::find(same, std::pair(protocol, description)) != std::end(same);
}

TEST(BusProbe, NoProtocolOfTheRegistryIsTakenForADescription) {
  BusSurvey::Descriptions named;
  for (const auto& one : rig_config::shipped_descriptions())
    if (one->frames) named.push_back(one);
  int tried = 0;
  const auto expect_own = [&](std::string_view protocol, const Frames& frames) {
    ++tried;
    for (const auto& found : protocols(nodes_of(frames, named)))
      EXPECT_TRUE(!found.ends_with(".toml") || is_described_by(protocol, found))
          << protocol << " is taken for " << found;
  };
  for (const wire::Protocol& protocol : wire::protocols()) {
    if (protocol.travels != wire::Travels::as_frames) continue;
    const auto name = std::string(protocol.name);
    const auto log = wire::test::fixture(name + "/frames.log");
    Frames golden;
    if (std::filesystem::exists(log))
      for (const auto& one : wire::test::frames_of_log(log)) golden.push_back({{}, one});
    expect_own(name, golden);
    for (const Kind kind : measurement::kinds)
      if (protocol.kinds.has(kind) && protocol.emulated)
        expect_own(name, frames_of(kind, name, nullptr));
  }
  EXPECT_GE(tried, 15);
}

}  // namespace bus_probe_test
}  // namespace drydock::described::test
