#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/host/rig_recorder.hpp"
#include "hil/python/callback_peer.hpp"
#include "hil/python/run_log.hpp"
#include "hil/python/steerer.hpp"
#include "hil/python/truth_sampler.hpp"
#include "hil/summary/summary.hpp"
#include "rig_config/rig.hpp"

namespace drydock::python {

struct LockstepOptions {
  double duration_s = 0;  ///< 0: one lap of the mission
  std::vector<EstimatorCallback> estimators;
  std::optional<Steerer::Controller> controller;
  std::chrono::nanoseconds truth_period{};
  std::optional<std::uint64_t> seed;
  std::string faults;  ///< TOML
  host::RecordOptions record;
};

/// A run in virtual time with functions of Python, and what it keeps.
class LockstepRun {
 public:
  /// `file`: a rig file, or the name of a shipped one. The options must outlive the run. Throws
  /// std::invalid_argument with lines for a rig that cannot be used so. Neither the constructor nor
  /// run() needs the interpreter's lock.
  LockstepRun(const std::string& file, const LockstepOptions& options);

  /// Throws std::runtime_error with one line if it cannot begin.
  void run();

  /// Throws the first exception of a callback, and as throw_if_ended().
  py::dict take();

 private:
  const LockstepOptions& options_;
  rig_config::Rig rig_;
  RunNames names_;
  Failure failure_;
  RunLog log_;
  std::unique_ptr<motion::Trajectory> motion_;
  std::optional<Steerer> steerer_;
  std::optional<TruthSampler> truth_;
  summary::Summary summary_;
};

}  // namespace drydock::python
