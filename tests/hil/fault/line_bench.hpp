#pragma once

#include <gtest/gtest.h>

#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "hil/emulate/lockstep.hpp"
#include "hil/fault/injector.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "rig_config/load.hpp"

namespace drydock::fault::test {

/// One serial device and its driver.
class LineBench final : private device::Listener, private device::Transmitter {
 public:
  explicit LineBench(const std::string& device_table, const std::string& faults = "")
      : rig_(rig_config::load_rig_text(
                 "[rig]\nname = \"r\"\nmission = \"s-path.toml\"\n" + device_table + faults,
                 DRYDOCK_SOURCE_DIR "/rig_config/missions/r.toml")
                 .value()),
        trajectory_(motion::make_trajectory(rig_.mission, start_)),
        injector_(rig_, *trajectory_, start_),
        clock_(start_),
        actor_(std::move((*shell::make_devices(rig_))[0]), *this, *this, start_),
        line_(*injector_.device(rig_.devices[0]), 115200,
              [this](wire::Bytes bytes, const emulate::Passage& passage) {
                carried_ += bytes.size();
                actor_.receive(bytes, passage.ended_at);
              }) {
    line_.set_on_port([this](bool there, Stamp at) { actor_.set_port(there, at); });
    clock_.add(actor_);
    clock_.add(line_);
  }

  void run_to(double seconds) { clock_.run_until(start_ + measurement::from_seconds(seconds)); }

  template <class Kind>
  std::vector<Kind> between(double from_s, double to_s) const {
    std::vector<Kind> all;
    for (const auto& m : measurements_) {
      const double t = measurement::seconds(measurement::origin_of(m).received_at - start_);
      if (const auto* kind = std::get_if<Kind>(&m); kind && t >= from_s && t < to_s)
        all.push_back(*kind);
    }
    return all;
  }
  const rig_config::Rig& rig() const { return rig_; }
  bool set(const FaultConfig& fault) { return injector_.set(fault, clock_.now()).has_value(); }
  std::uint64_t bytes_carried() const { return carried_; }
  device::Health health() const { return actor_.device().health(clock_.now()); }

 private:
  void on_measurement(const measurement::Measurement& m) override { measurements_.push_back(m); }
  void on_state(const device::Device&, const device::Transition&) override {}
  void send(wire::Bytes bytes) override { line_.receive(bytes, clock_.now()); }
  void send(const wire::CanFrame&) override { ADD_FAILURE() << "a frame on a serial line"; }

  Stamp start_ = measurement::stamp_from_ns(1'795'248'000'000'000'000);
  rig_config::Rig rig_;
  std::unique_ptr<motion::Trajectory> trajectory_;
  Injector injector_;
  shell::Lockstep clock_;
  shell::DeviceActor actor_;
  emulate::EmulatedLine line_;
  std::vector<measurement::Measurement> measurements_;
  std::uint64_t carried_ = 0;
};

}  // namespace drydock::fault::test
