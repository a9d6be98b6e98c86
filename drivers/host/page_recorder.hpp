#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/live/foxglove/services.hpp"

namespace drydock::host {

/// A recording that viewers of the page start and stop: `--allow-recording FOLDER`.
class PageRecorder final : public Follower {
 public:
  using Now = std::function<Stamp()>;

  /// The rig must outlive it. Throws std::runtime_error with one line if the folder cannot be made.
  PageRecorder(const rig_config::Rig& rig, std::string folder, Now now);

  /// /drydock/recording/start, stop and state. Each answers with the state. It must outlive them.
  std::vector<live::Service> services();

  bool records() const { return recorder_.has_value(); }
  std::string finish();  ///< one line about the recording that runs; empty: none runs

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override;
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override;
  void on_measurement(const measurement::Measurement& measurement) override;
  void on_estimate(const Estimate& estimate) override;
  void on_truth(const Estimate& truth) override;
  void on_innovation(const bus::Innovation& innovation) override;
  void on_health(const HealthReport& health, Stamp now) override;
  void on_finding(const diagnosis::Finding& finding) override;
  void on_faults(std::span<const bus::Fault> faults, Stamp now) override;
  void tick(Stamp now) override;

 private:
  live::ServiceAnswer start();
  live::ServiceAnswer stop();
  std::string state_json() const;

  const rig_config::Rig& rig_;
  std::string folder_;
  Now now_;
  std::optional<RigRecorder> recorder_;
  std::string path_, last_;  ///< of the recording that runs; the line about the one before
  Stamp since_{};
  std::vector<bus::Fault> faults_;  ///< in force
};

}  // namespace drydock::host
