#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "hil/check/check_rig.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/python/columns.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"
#include "hil/python/truth_fields.hpp"
#include "rig_config/load.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::python {
namespace {

using measurement::Stamp;
using Times = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Of a table without times: some gigabytes.
constexpr double most_rows = 1e7;

std::unique_ptr<motion::Trajectory> motion_of(const std::string& file, Stamp start) {
  const auto mission =
      rig_config::load_mission(rig_config::find_shipped(file, rig_config::missions)).value();
  if (mission.steering)
    throw std::invalid_argument(
        file +
        ": another program steers its vehicle, so it has no motion of its own; "
        "drydock.run with a controller gives the truth of its run");
  if (const auto problems = check::check_mission(mission); !problems.empty())
    throw std::invalid_argument(to_string(problems.front()));
  return motion::make_trajectory(mission, start);
}

std::vector<double> every(double step_s, const motion::Trajectory& motion) {
  if (!(step_s > 0)) throw std::invalid_argument("every_s is not above 0");
  std::vector<double> times;
  const double lap_s = measurement::seconds(motion.end() - motion.start());
  if (const double least_s = std::max(1e-9, lap_s / most_rows); !(step_s >= least_s))
    throw std::invalid_argument(fmt::format(
        "every_s is {}, allowed for this lap of {} s: {:.3g} and more", step_s, lap_s, least_s));
  for (std::size_t k = 0; static_cast<double>(k) * step_s <= lap_s; ++k)
    times.push_back(static_cast<double>(k) * step_s);
  return times;
}

py::dict truth(const std::string& mission, const std::optional<Times>& times_s, double every_s,
               std::int64_t start_ns) {
  if (times_s && times_s->ndim() > 1)
    throw std::invalid_argument(
        fmt::format("times_s has {} dimensions, allowed: one, a row of times", times_s->ndim()));
  const std::span<const double> asked =
      times_s ? std::span(times_s->data(), static_cast<std::size_t>(times_s->size()))
              : std::span<const double>();
  const Stamp start = measurement::stamp_from_ns(start_ns);
  Columns columns;
  {
    const OutsidePython others_run;
    const auto motion = motion_of(mission, start);
    const auto add = [&](double t) {
      columns.begin_row();
      visit_fields(motion->at(start + measurement::from_seconds(t)),
                   [&](std::string_view name, const auto& value) { columns.field(name, value); });
    };
    add(0);  // for the columns of a table without times
    columns.drop_rows();
    const auto lap = times_s ? std::vector<double>() : every(every_s, *motion);
    for (const double t : times_s ? asked : std::span<const double>(lap)) {
      if (!(std::abs(t) < 1e9))
        throw std::invalid_argument(fmt::format("times_s has {}, allowed: below 1e9 s", t));
      add(t);
    }
  }
  return columns.take();
}

}  // namespace

void add_truth(py::module_& module) {
  using py::arg;
  module.def("truth", &truth, arg("mission"), arg("times_s") = py::none(), py::kw_only(),
             arg("every_s") = 1.0, arg("start_ns") = 0,
             "The true motion of a mission at these times since its start; without times, of one "
             "lap.");
}

}  // namespace drydock::python
