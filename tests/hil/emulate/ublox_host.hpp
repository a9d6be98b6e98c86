#pragma once

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "drivers/wire/ubx/ubx_nmea.hpp"
#include "drivers/wire/ubx/ubx_put.hpp"
#include "drivers/wire/ubx/ubx_settings.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {

/// A host at the port of an emulated receiver, without a line between.
class UbloxHost : public Wire {
 public:
  explicit UbloxHost(rig_config::UbloxModel model, double rate_hz = 1,
                     std::shared_ptr<Memory> memory = std::make_shared<Memory>())
      : device_(made(model, rate_hz, std::move(memory))) {}

  void send(wire::Bytes bytes) override { heard.emplace_back(bytes.begin(), bytes.end()); }
  void send(const wire::CanFrame&) override {}
  void set_baud(unsigned baud) override { bauds.push_back(baud); }
  void tell(std::string_view what) override { told.emplace_back(what); }

  /// Says it and returns all that the receiver answers.
  std::vector<std::vector<std::uint8_t>> say(wire::Bytes bytes) {
    heard.clear();
    device_->receive(bytes, now, *this);
    return heard;
  }
  std::vector<std::vector<std::uint8_t>> say(std::uint16_t id,
                                             const std::vector<std::uint8_t>& payload = {}) {
    std::array<std::uint8_t, 256> frame;
    return say(wire::Bytes{frame}.first(wire::ubx::encode_frame(id, payload, frame)));
  }
  bool acknowledges(std::uint16_t id, const std::vector<std::uint8_t>& payload) {
    const auto answers = say(id, payload);
    return !answers.empty() &&
           wire::ubx::packet_of(answers.back()).class_and_id == wire::ubx::ack_ack;
  }

  /// What it sends by itself for some seconds.
  void listen(double seconds) {
    heard.clear();
    times.clear();
    const Stamp end = now + measurement::from_seconds(seconds);
    for (auto due = device_->deadline(); due && *due <= end; due = device_->deadline()) {
      now = *due;
      device_->tick(now, *this);
      times.resize(heard.size(), now);
    }
    now = end;
  }
  template <class Message>
  std::vector<Message> all() const {
    std::vector<Message> found;
    for (const auto& frame : heard) {
      const auto decoded = wire::UbxNmea::decode(frame);
      if (!decoded) continue;
      if (const auto* m = std::get_if<Message>(&*decoded)) found.push_back(*m);
    }
    return found;
  }
  std::size_t count(std::uint16_t id) const {
    return static_cast<std::size_t>(std::ranges::count_if(heard, [&](const auto& frame) {
      return frame[0] == 0xB5 && wire::ubx::packet_of(frame).class_and_id == id;
    }));
  }

  Stamp now = start;
  std::vector<std::vector<std::uint8_t>> heard;
  std::vector<Stamp> times;
  std::vector<unsigned> bauds;
  std::vector<std::string> told;

 private:
  std::unique_ptr<EmulatedDevice> made(rig_config::UbloxModel model, double rate_hz,
                                       std::shared_ptr<Memory> memory) {
    auto config = device(rig_config::DeviceKind::gnss, "ubx", rate_hz);
    config.emulate.model = model;
    return make_emulated_device(config, trajectory_, 1,
                                {start, std::make_shared<Condition>(), std::move(memory)})
        .value();
  }

  Frozen trajectory_{at_the_surface()};
  std::unique_ptr<EmulatedDevice> device_;
};

}  // namespace drydock::emulate
