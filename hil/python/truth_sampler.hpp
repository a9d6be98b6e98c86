#pragma once

#include "drivers/shell/lockstep.hpp"
#include "hil/python/columns.hpp"
#include "hil/python/truth_fields.hpp"

namespace drydock::python {

/// Keeps the truth of a run at equal intervals of its virtual time.
class TruthSampler final : public shell::Actor {
 public:
  /// The motion must outlive the sampler.
  TruthSampler(const motion::Trajectory& motion, std::chrono::nanoseconds period)
      : motion_(motion), period_(period), next_(motion.start()) {}

  std::optional<measurement::Stamp> deadline() const override { return next_; }
  void act(measurement::Stamp now) override {
    columns_.begin_row();
    visit_fields(motion_.at(now),
                 [&](std::string_view name, const auto& value) { columns_.field(name, value); });
    next_ += period_;
  }
  py::dict take() { return columns_.take(); }

 private:
  const motion::Trajectory& motion_;
  std::chrono::nanoseconds period_;
  measurement::Stamp next_;
  Columns columns_;
};

}  // namespace drydock::python
