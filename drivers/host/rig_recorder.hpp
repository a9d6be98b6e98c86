#pragma once

#include "drivers/host/watcher.hpp"
#include "drivers/recordings/record/recorder.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

struct RecordOptions {
  std::string path;        ///< the MCAP file; empty: no recording
  bool overwrite = false;  ///< replace an existing file
};

/// Records the run of a rig: all data on its links, all results of its drivers and estimators, and
/// the rig's files as attachments.
class RigRecorder final : public Watcher {
 public:
  /// Throws std::runtime_error with one line if the file cannot be made.
  RigRecorder(const rig_config::Rig& rig, const RecordOptions& options, Stamp start,
              record::WhenBehind when_behind);

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override {
    recorder_.on_bytes(link, way, bytes, at);
  }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    recorder_.on_frame(link, way, frame, at);
  }
  void note(const measurement::Measurement& measurement) override {
    recorder_.topics().publish(measurement);
  }
  void note(const bus::Attitude& attitude, std::size_t estimator) override {
    recorder_.topics().publish(attitude, estimator);
  }
  void note(const bus::Navigation& navigation, std::size_t estimator) override {
    recorder_.topics().publish(navigation, estimator);
  }
  void note(std::span<const bus::DeviceStatus> health, Stamp now) override {
    recorder_.topics().publish(health, now);
  }
  void note(const bus::Innovation& innovation) override { recorder_.topics().publish(innovation); }
  void note(std::span<const bus::Fault> faults, Stamp now) override {
    recorder_.topics().publish(faults, now);
  }
  void tick(Stamp now) override;  ///< reports once on standard error if the file fails

  /// Ends the file. Returns one line about its content, or about the failure.
  std::string finish();
  bool failed() const { return recorder_.status().error.failed(); }

 private:
  std::string path_;
  record::Recorder recorder_;
  bool told_ = false;
};

}  // namespace drydock::host
