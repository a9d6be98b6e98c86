#pragma once

#include <memory>
#include <string>
#include <vector>

#include "drivers/shell/lockstep.hpp"
#include "hil/motion/steered/steered_trajectory.hpp"
#include "hil/python/callback.hpp"
#include "hil/python/run_log.hpp"

namespace drydock::python {

/// Names of what callbacks see, in the order of the rig.
struct RunNames {
  std::shared_ptr<const std::vector<std::string>> devices, estimators;
};

/// A controller that is a Python function: it gets a Moment and gives the vehicle's outputs, -1 to
/// 1 each, which hold until its next call.
class Steerer final : public shell::Actor {
 public:
  struct Controller {
    py::function call;
    std::chrono::nanoseconds period;
  };

  /// All of them must outlive the steerer, which holds nothing of Python. `outputs`: how many the
  /// vehicle takes.
  Steerer(const Controller& controller, motion::SteeredTrajectory& motion, RunLog& log,
          std::size_t outputs, const RunNames& names, Failure& failure);

  std::optional<measurement::Stamp> deadline() const override { return next_; }
  void act(measurement::Stamp now) override;

 private:
  std::vector<double> ask(measurement::Stamp now);

  const Controller& controller_;
  motion::SteeredTrajectory& motion_;
  RunLog& log_;
  std::size_t most_outputs_;
  const RunNames& names_;
  Failure& failure_;
  measurement::Stamp next_;
  std::vector<double> outputs_;
};

void add_moment_object(py::module_& module);

}  // namespace drydock::python
