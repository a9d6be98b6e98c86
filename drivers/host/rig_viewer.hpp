#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <optional>

#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "drivers/host/finding_status.hpp"
#include "drivers/host/follower.hpp"
#include "drivers/host/integrity_status.hpp"
#include "drivers/live/live_topics.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// The address where a run can be watched: `--serve [ADDRESS:PORT]`, `--token`, `--allow-faults`,
/// `--allow-recording`.
struct ServeOptions {
  std::string address;  ///< "127.0.0.1:8765", ":8765", "8765"; empty: not served
  std::string token;
  bool allow_faults = false;  ///< viewers may set and clear faults
  std::string recordings;     ///< folder in which viewers may record; empty: they may not
};

/// The content that a viewer may see.
struct Viewed {
  std::string name;
  std::vector<bus::Device> devices;                     ///< by `Origin::device`
  std::vector<std::string> estimators{}, navigators{};  ///< navigators give Navigation too
  std::vector<bus::InnovationSource> innovations{};
};
Viewed viewed(const rig_config::Rig& rig);

/// Shows a run in browsers and Foxglove. It thins fast topics to a rate that an eye can follow.
class RigViewer final : public Follower {
 public:
  static constexpr std::chrono::milliseconds shortest_interval{40};

  /// Throws std::runtime_error with one line if the address cannot be served. An address that other
  /// hosts can reach gets a random token if none is given.
  RigViewer(boost::asio::any_io_executor executor, const Viewed& viewed,
            const ServeOptions& options);
  RigViewer(boost::asio::any_io_executor executor, const rig_config::Rig& rig,
            const ServeOptions& options)
      : RigViewer(std::move(executor), viewed(rig), options) {}

  void add(std::vector<live::Service> services);

  std::string url() const;  ///< for a browser; includes the token if there is one

  void on_measurement(const measurement::Measurement& measurement) override;
  void on_estimate(const Estimate& estimate) override;
  void on_truth(const Estimate& truth) override { show(truth, truth_); }
  void on_innovation(const bus::Innovation& innovation) override { topics_.publish(innovation); }
  void on_health(const HealthReport& health, Stamp now) override {
    topics_.publish(health.statuses(), now);
    if (!findings_.open().empty()) topics_.publish(findings_.open(), now);
    look(now);
  }
  void on_finding(const diagnosis::Finding& finding) override {
    const auto status = findings_.take(finding);
    topics_.publish({&status, 1}, finding.until.value_or(finding.found));
  }
  void on_faults(std::span<const bus::Fault> faults, Stamp now) override;
  void tick(Stamp now) override;  ///< repeats the faults in force, for viewers that connected later
  void stop() { server_.stop(); }
  live::ServerCounters counters() const { return server_.counters(); }

 private:
  void show(const Estimate& estimate, std::size_t index);
  bool due(Stamp& last, Stamp now) const;
  /// Shows which estimates are too old by now.
  void look(Stamp now) {
    integrity_.look(now, [&](const bus::DeviceStatus& status) {
      topics_.publish({&status, 1}, now);
    });
  }

  live::ServerOptions options_;
  live::Server server_;
  live::LiveTopics sink_;
  bus::CdrPublisher topics_;
  FindingStatuses findings_;
  IntegrityStatuses integrity_;
  std::size_t truth_;               ///< the truth is shown as one more estimator
  std::vector<bus::Fault> faults_;  ///< in force
  Stamp faults_told_{};
  std::vector<Stamp> last_sample_;                    ///< by device; only for IMUs
  std::vector<Stamp> last_attitude_, last_position_;  ///< by estimator
};

}  // namespace drydock::host
