#pragma once

#include <boost/system/result.hpp>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drivers/measurement/measurement.hpp"
#include "estimators/pipeline/estimator.hpp"
#include "estimators/pipeline/listener.hpp"
#include "estimators/pipeline/options.hpp"
#include "estimators/pipeline/reorder_buffer.hpp"

/// From measurements in any order to estimates in order. No clock, no I/O, no thread: the same
/// measurements and the same calls of advance() give the same estimates to the last bit.
namespace drydock::pipeline {

/// received = waiting + accepted + delayed + late + refused + unused. A device that feeds several
/// estimators counts by the best outcome.
struct DeviceCounters {
  std::uint64_t received = 0;
  std::uint64_t accepted = 0, delayed = 0, late = 0, refused = 0, unused = 0;
};

class Pipeline {
 public:
  /// `make_pipeline` is the usual way; this one takes ready estimators.
  Pipeline(const PipelineOptions& options, EstimateListener& listener,
           std::vector<std::unique_ptr<Estimator>> estimators);

  /// Takes one measurement and lets go on what has waited long enough: everything at least
  /// `reorder_window` older than the newest valid_at seen.
  void receive(const measurement::Measurement& measurement);

  /// Says that it is `now`: what is `reorder_window` older goes on, even if all sensors fell
  /// silent.
  void advance(measurement::Stamp now);

  /// Lets everything go on that waits: the end of a run.
  void flush();

  /// Indexed by device; devices that never spoke may be missing at the end.
  const std::vector<DeviceCounters>& counters() const { return counters_; }
  /// Measurements that went on early because the buffer was full.
  std::uint64_t overflows() const { return overflows_; }

  std::size_t estimators() const { return estimators_.size(); }
  const EstimatorStatus& status(std::size_t estimator) const {
    return estimators_[estimator]->status();
  }

 private:
  void order(const Sample& sample);
  void release();
  void run(const Sample& sample);
  void count(std::uint16_t device, Outcome outcome);
  DeviceCounters& of(std::uint16_t device);

  std::chrono::nanoseconds window_;
  EstimateListener* listener_;
  std::vector<std::unique_ptr<Estimator>> estimators_;
  ReorderBuffer buffer_;
  measurement::Stamp newest_ = measurement::Stamp::min();
  std::vector<DeviceCounters> counters_;
  std::uint64_t overflows_ = 0;
};

/// One line: which estimator, what is wrong, what is allowed.
struct PipelineError {
  std::string message;
};

boost::system::result<Pipeline, PipelineError> make_pipeline(const PipelineOptions& options,
                                                             EstimateListener& listener);

}  // namespace drydock::pipeline
