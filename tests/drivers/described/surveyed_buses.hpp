#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/survey/bus_survey.hpp"
#include "tests/drivers/described/dbc_folder.hpp"

/// Buses with described sensors, a node of CANopen and one of NMEA 2000, and what a survey says of
/// them.
namespace drydock::described::test {

using survey::BusSurvey;
using survey::Node;
using survey::NodeKind;
using Frames = std::vector<emulate::Recorder::Frame>;

constexpr double surveyed_s = 2;

inline Frames frames_of(Kind kind, const std::string& protocol, const DescriptionPtr& description,
                        int address = 0) {
  auto config = emulate::device(kind, protocol, 50);
  config.description = description;
  if (address != 0) config.address = address;
  const emulate::Frozen truth(emulate::under_way());
  return emulate::record(config, truth, surveyed_s).frames;
}
inline Frames frames_of(const DescriptionPtr& one) { return frames_of(*one->kind, one->name, one); }

/// A transmitter as node 21: it boots, sends heartbeats and 100000 Pa, and answers a question for
/// its device type (CiA 404).
inline Frames canopen_node() {
  Frames all{{emulate::at_s(0), frame("715#00")},
             {emulate::at_s(0.1), frame("595#4300100094010200")}};
  for (int i = 0; i < 20; ++i) {
    all.push_back({emulate::at_s(0.1 * i + 0.03), frame("715#05")});
    all.push_back({emulate::at_s(0.1 * i + 0.05), frame("195#A086010000")});
  }
  return all;
}

/// A receiver that claims address 52: 34.4 N 133.5 E, of canboat's samples.
inline Frames nmea2000_node() {
  Frames all{{emulate::at_s(0), frame("18EEFF34#39300010008278C0")}};
  for (int i = 0; i < 20; ++i)
    all.push_back({emulate::at_s(0.1 * i + 0.07), frame("09F80134#19EE8114E4C5984F")});
  return all;
}

inline Frames operator+(Frames a, const Frames& b) {
  a.insert(a.end(), b.begin(), b.end());
  std::ranges::stable_sort(a, {}, &emulate::Recorder::Frame::at);
  return a;
}

inline std::vector<Node> nodes_of(const Frames& frames, const BusSurvey::Descriptions& named) {
  BusSurvey survey(named);
  for (const auto& [at, one] : frames) survey.receive(one, at);
  return survey.nodes();
}

inline std::vector<std::string> protocols(const std::vector<Node>& nodes) {
  std::vector<std::string> names;
  for (const Node& node : nodes)
    for (const auto& sensor : node.sensors) names.emplace_back(sensor.protocol);
  return names;
}

inline const Node* node_with(const std::vector<Node>& nodes, std::string_view protocol) {
  for (const Node& node : nodes)
    for (const auto& sensor : node.sensors)
      if (sensor.protocol == protocol) return &node;
  return nullptr;
}

inline const Node* node_at(const std::vector<Node>& nodes, NodeKind kind, int address) {
  const auto found = std::ranges::find_if(
      nodes, [&](const Node& node) { return node.kind == kind && node.address == address; });
  return found == nodes.end() ? nullptr : &*found;
}

inline void expect_both_neighbours(const std::vector<Node>& nodes) {
  const Node* transmitter = node_at(nodes, NodeKind::canopen, 21);
  ASSERT_TRUE(transmitter);
  EXPECT_EQ(transmitter->device_type, 0x00020194u);
  EXPECT_TRUE(transmitter->booted);
  EXPECT_THAT(protocols({*transmitter}), testing::Contains("cia404-pressure"));
  const Node* receiver = node_at(nodes, NodeKind::j1939, 52);
  ASSERT_TRUE(receiver);
  EXPECT_TRUE(receiver->name);
  EXPECT_THAT(protocols({*receiver}), testing::Contains("nmea2000"));
}

}  // namespace drydock::described::test
