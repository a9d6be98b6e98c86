#pragma once

#include "drivers/host/finding_status.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/host/integrity_status.hpp"
#include "drivers/recordings/record/recorder.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

struct RecordOptions {
  std::string path;        ///< the MCAP file; empty: no recording
  bool overwrite = false;  ///< replace an existing file; a divided recording replaces none
  record::Split split{};
};

/// Records the run of a rig: all data on its links, all results of its drivers and estimators, and
/// the rig's files as attachments. In real time what was written is on the disk; a run in virtual
/// time can be repeated, and does not wait for that.
class RigRecorder final : public Follower {
 public:
  /// Throws std::runtime_error with one line if the file cannot be made.
  RigRecorder(const rig_config::Rig& rig, const RecordOptions& options, Stamp start,
              record::WhenBehind when_behind);
  ~RigRecorder() override;  ///< removes a file that was never finished and has no message
  RigRecorder(const RigRecorder&) = delete;
  RigRecorder& operator=(const RigRecorder&) = delete;

  void on_bytes(std::string_view link, shell::Direction way, wire::Bytes bytes, Stamp at) override {
    recorder_.on_bytes(link, way, bytes, at);
  }
  void on_frame(std::string_view link, shell::Direction way, const wire::CanFrame& frame,
                Stamp at) override {
    recorder_.on_frame(link, way, frame, at);
  }
  void on_measurement(const measurement::Measurement& measurement) override {
    recorder_.topics().publish(measurement);
    look(measurement::origin_of(measurement).received_at);
  }
  void on_estimate(const Estimate& estimate) override {
    record(estimate, estimate.estimator);
    if (const auto status = integrity_.take(estimate))
      recorder_.topics().publish({&*status, 1}, estimate.attitude.valid_at);
  }
  void on_truth(const Estimate& truth) override { record(truth, truth_); }
  void on_innovation(const bus::Innovation& innovation) override {
    recorder_.topics().publish(innovation);
  }
  void on_health(const HealthReport& health, Stamp now) override {
    recorder_.topics().publish(health.statuses(), now);
    if (!findings_.open().empty()) recorder_.topics().publish(findings_.open(), now);
    look(now);
  }
  void on_finding(const diagnosis::Finding& finding) override {
    const auto status = findings_.take(finding);
    recorder_.topics().publish({&status, 1}, finding.until.value_or(finding.found));
  }
  void on_faults(std::span<const bus::Fault> faults, Stamp now) override {
    recorder_.topics().publish(faults, now);
  }
  void tick(Stamp now) override;  ///< reports once on standard error if the file fails

  /// Ends the file. Returns one line about its content, or about the failure.
  std::string finish();
  std::uint64_t bytes() const { return recorder_.status().bytes; }  ///< written until now
  bool failed() const { return recorder_.status().error.failed(); }

 private:
  RigRecorder(const rig_config::Rig& rig, record::Parts parts, Stamp start,
              record::WhenBehind when_behind);
  void record(const Estimate& estimate, std::size_t index);
  /// Records which estimates are too old by now.
  void look(Stamp now) {
    integrity_.look(now, [&](const bus::DeviceStatus& status) {
      recorder_.topics().publish({&status, 1}, now);
    });
  }

  std::string path_;  ///< of a divided recording, its first file
  record::Recorder recorder_;
  FindingStatuses findings_;
  IntegrityStatuses integrity_;
  std::size_t truth_;  ///< the truth is recorded as one more estimator
  bool told_ = false, finished_ = false;
};

}  // namespace drydock::host
