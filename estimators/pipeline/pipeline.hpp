#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/listener.hpp"
#include "estimators/pipeline/missing_estimates.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/reorder_buffer.hpp"

/// Turns measurements in any order into estimates in order. It has no clock, no I/O and no thread:
/// the same measurements and the same calls of advance() give the same estimates to the last bit.
namespace drydock::pipeline {

/// received = waiting + accepted + delayed + late + refused + unused + left_out. If a device feeds
/// several estimators, the best outcome counts.
struct DeviceCounters {
  std::uint64_t received = 0;
  std::uint64_t accepted = 0, delayed = 0, late = 0, refused = 0, unused = 0;
  std::uint64_t left_out = 0;  ///< because the device is not sound, see Pipeline::leave_out
};

class Pipeline {
 public:
  /// Takes finished estimators. Use `make_pipeline` to build them from options.
  Pipeline(const PipelineOptions& options, EstimateListener& listener,
           std::vector<std::unique_ptr<Estimator>> estimators);

  /// Takes one measurement. Then runs all waiting measurements that are more than `reorder_window`
  /// older than the newest valid_at.
  void receive(const measurement::Measurement& measurement);

  /// Sets the time to `now`, so that waiting measurements run even if all sensors are silent.
  void advance(measurement::Stamp now);

  /// True: no measurement of the device with a valid_at of `from` or later is used, until false
  /// takes it back, likewise from that time on. For a device that a finding names.
  void leave_out(std::uint16_t device, bool left_out, measurement::Stamp from);
  bool left_out(std::uint16_t device) const;

  /// True: estimates that need the device are not valid, until false takes it back. For a device
  /// that a finding names and without which there is no estimate.
  void doubt(std::uint16_t device, bool doubted);

  /// Runs all waiting measurements and lets the estimators finish, for the end of a run.
  void flush();

  /// Indexed by device. Devices without any measurement may be missing at the end.
  const std::vector<DeviceCounters>& counters() const { return counters_; }
  /// True if the estimator gives valid estimates at `now`: its last one is valid, and not older
  /// than the reorder window and the longest gap of its sensors.
  bool valid(std::size_t estimator, measurement::Stamp now) const;

  /// Number of measurements that ran early because the buffer was full.
  std::uint64_t overflows() const { return overflows_; }

  std::size_t estimators() const { return estimators_.size(); }
  /// Of an estimator in another program; null for all others.
  const PeerAccount* peer(std::size_t estimator) const { return estimators_[estimator]->peer(); }
  EstimatorStatus status(std::size_t estimator) const;

 private:
  void order(const Sample& sample);
  void release();
  void run(const Sample& sample);
  void note_missing();
  void count(std::uint16_t device, Outcome outcome);
  DeviceCounters& of(std::uint16_t device);
  bool is_left_out(const measurement::Origin& origin) const;

  /// From when a device is left out, or not.
  struct LeftOut {
    bool now = false;
    measurement::Stamp since = measurement::Stamp::min();
  };

  std::chrono::nanoseconds window_, max_gap_;
  EstimateListener* listener_;
  std::vector<std::unique_ptr<Estimator>> estimators_;
  std::vector<MissingEstimates> missing_;  ///< by estimator
  ReorderBuffer buffer_;
  measurement::Stamp newest_ = measurement::Stamp::min();
  measurement::Stamp latest_{};  ///< as newest_, but a clock may set it back
  std::vector<DeviceCounters> counters_;
  std::vector<LeftOut> left_out_;  ///< by device; those never left out may be missing at the end
  std::uint64_t overflows_ = 0;
};

/// One line: which estimator, what is wrong, what is allowed.
struct PipelineError {
  std::string message;
};

/// Called by result::value() if there is no pipeline; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const PipelineError& error,
                                             const boost::source_location& where);

boost::system::result<Pipeline, PipelineError> make_pipeline(const PipelineOptions& options,
                                                             EstimateListener& listener);

}  // namespace drydock::pipeline
