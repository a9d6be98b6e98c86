#pragma once

#include "tests/hil/emulate/ordered_node.hpp"

namespace drydock::emulate {

/// An emulated node 1 after its boot, spoken to in candump's form.
struct Master {
  explicit Master(const rig_config::DeviceConfig& config)
      : node(make_emulated_device(config, trajectory, 1).value()) {
    sent.run(*node, start);
  }
  explicit Master(const rig_config::DeviceConfig& config, const PowerUp& power)
      : node(make_emulated_device(config, trajectory, 1, power).value()) {
    sent.run(*node, start);
  }
  std::string hear(const wire::CanFrame& heard) {
    sent.frames.clear();
    node->receive(heard, sent.now, sent);
    return sent.frames.empty() ? "" : text_of(sent.frames.back().frame);
  }
  std::string ask(const std::string& text) { return hear(frame(text)); }
  /// The text that an object has, by segments, as CiA 301 has them.
  std::string text(const std::string& mux) {
    if (ask("601#40" + mux + "00000000").substr(0, 12) != "581#41" + mux) return "no segments";
    std::string all;
    for (unsigned toggle = 0;; toggle ^= 0x10) {
      ask(toggle == 0 ? "601#6000000000000000" : "601#7000000000000000");
      const auto& data = sent.frames.back().frame.data;
      if ((data[0] & 0xF0) != toggle) return "wrong toggle";
      all.append(data.begin() + 1, data.begin() + 8 - (data[0] >> 1 & 7));
      if ((data[0] & 1) != 0) return all;
    }
  }
  /// How often a frame came until a time.
  std::size_t count(std::uint32_t id, double until_s) {
    sent.frames.clear();
    sent.run(*node, at_s(until_s));
    return static_cast<std::size_t>(std::ranges::count_if(
        sent.frames, [&](const auto& message) { return message.frame.id == id; }));
  }

  Frozen trajectory{under_way()};
  std::unique_ptr<EmulatedDevice> node;
  Recorder sent;
};

/// The answer to a write that was obeyed.
inline bool taken(const std::string& answer) { return answer.substr(0, 6) == "581#60"; }

}  // namespace drydock::emulate
