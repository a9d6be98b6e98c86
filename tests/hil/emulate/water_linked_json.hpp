#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/hil/emulate/bench.hpp"

/// An emulated DVL of Water Linked with its clients. A JSON library of others reads what it sends.
namespace drydock::emulate {

using nlohmann::json;

/// Remembers to whom each answer was sent.
class Room final : public Wire {
 public:
  void send(wire::Bytes bytes) override { send_to(every_client, bytes); }
  void send(const wire::CanFrame&) override {}
  void send_to(Client client, wire::Bytes bytes) override {
    said.push_back({client, std::string(bytes.begin(), bytes.end())});
  }
  Client speaker() const override { return asks; }

  struct Said {
    Client to;
    std::string text;
  };
  std::vector<Said> said;
  Client asks = 7;
};

class WaterLinkedJsonDvl : public testing::Test {
 protected:
  WaterLinkedJsonDvl() : trajectory_(under_way()) {
    config_.emulate.latency_s = 0.04;
    make(trajectory_);
  }

  void make(const motion::Trajectory& trajectory) {
    dvl_ = make_emulated_device(config_, trajectory, 1).value();
    now_ = start;
  }

  void run_to(double seconds) {
    for (auto due = dvl_->deadline(); due && *due <= at_s(seconds); due = dvl_->deadline())
      dvl_->tick(*due, room_);
    now_ = at_s(seconds);
  }

  /// What it sends until then, of one type.
  std::vector<json> sent_until(double seconds, const std::string& type) {
    room_.said.clear();
    run_to(seconds);
    std::vector<json> found;
    for (const auto& said : room_.said) {
      EXPECT_TRUE(said.text.ends_with("}\r\n")) << said.text;
      if (json line = json::parse(said.text); line["type"] == type) found.push_back(line);
    }
    return found;
  }
  json report(double seconds = 0.05) { return sent_until(seconds, "velocity").at(0); }

  void say(std::string_view text) {
    dvl_->receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now_, room_);
  }
  json answer_to(std::string_view text) {
    room_.said.clear();
    say(text);
    return room_.said.empty() ? json() : json::parse(room_.said.back().text);
  }
  json set(const std::string& parameters) {
    return answer_to("{\"command\":\"set_config\",\"parameters\":" + parameters + "}");
  }
  json result_of(const std::string& command) {
    return answer_to("{\"command\":\"" + command + "\"}")["result"];
  }

  Frozen trajectory_;
  rig_config::DeviceConfig config_ = device(rig_config::DeviceKind::dvl, "water-linked-json", 5);
  std::unique_ptr<EmulatedDevice> dvl_;
  Room room_;
  Stamp now_ = start;
};

}  // namespace drydock::emulate
