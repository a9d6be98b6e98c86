#include "hil/python/run_log.hpp"

#include "hil/python/estimate_fields.hpp"

namespace drydock::python {

void RunLog::on_measurement(const measurement::Measurement& measurement) {
  measurements_.add(measurement);
  if (listens_) heard_.push_back(measurement);
}

void RunLog::on_estimate(const host::Estimate& estimate) {
  auto& columns = estimates_.at(estimate.estimator);
  columns.begin_row();
  visit_fields(estimate,
               [&](std::string_view name, const auto& value) { columns.field(name, value); });
  if (listens_) latest_.at(estimate.estimator) = estimate;
}

py::dict RunLog::take_estimates(std::span<const std::string> estimators) {
  py::dict all;
  for (std::size_t i = 0; i < estimators.size(); ++i)
    all[py::str(estimators[i])] = estimates_[i].take();
  return all;
}

}  // namespace drydock::python
