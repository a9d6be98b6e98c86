#include <fmt/format.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <thread>

#include "drivers/terminal/interrupt_flag.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/python/columns.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"
#include "hil/python/values.hpp"
#include "hil/study/run/run_study.hpp"

namespace drydock::python {
namespace {

class UntilInterrupted final : public study::Progress {
 public:
  void on_run(std::string_view, std::size_t, std::size_t) override {}
  /// Only the calling thread learns of a signal; the other ones hear it from that.
  bool stopped() const override {
    if (interrupt_.set()) stopped_ = true;
    return stopped_;
  }

 private:
  terminal::InterruptFlag interrupt_;
  mutable std::atomic<bool> stopped_ = false;
};

const study::Study& study_of(const std::string& name, const study::Options& options) {
  const auto all = study::studies();
  const auto found = std::ranges::find(all, name, &study::Study::name);
  if (found == all.end())
    throw std::invalid_argument(
        fmt::format("study '{}' is not known, allowed: {}", name, study::study_names()));
  if (const auto wrong = study::unknown_case(*found, options.cases))
    throw std::invalid_argument(fmt::format("study {}: {}", name, *wrong));
  return *found;
}

py::dict dict_of(report::Figure&& figure) {
  py::list curves;
  for (auto& curve : figure.curves) {
    py::dict one;
    one["label"] = curve.label;
    one["x"] = own(std::move(curve.x));
    one["y"] = own(std::move(curve.y));
    curves.append(std::move(one));
  }
  py::dict dict;
  dict["title"] = figure.title;
  dict["x_label"] = figure.x_label;
  dict["y_label"] = figure.y_label;
  dict["curves"] = std::move(curves);
  return dict;
}

py::dict dict_of(const report::Table& table) {
  py::dict dict;
  dict["title"] = table.title;
  dict["columns"] = table.columns;
  dict["rows"] = table.rows;
  dict["note"] = table.note;
  return dict;
}

py::dict run_study(const std::string& name, std::size_t runs, std::uint64_t seed, unsigned jobs,
                   std::vector<std::string> cases) {
  constexpr std::size_t most_runs = 1'000'000;
  if (runs < 1 || runs > most_runs)
    throw std::invalid_argument(fmt::format("runs = {}, allowed: 1 to {}", runs, most_runs));
  study::Options options{.runs = runs, .seed = seed, .jobs = jobs, .cases = std::move(cases)};
  if (jobs == 0) options.jobs = std::max(1U, std::thread::hardware_concurrency());
  const auto& study = study_of(name, options);
  study::Result result;
  {
    const OutsidePython others_run;
    UntilInterrupted progress;
    result = study.run(options, progress);
  }
  throw_if_ended();
  py::list tables, figures;
  for (const auto& table : result.tables) tables.append(dict_of(table));
  for (auto& figure : result.figures) figures.append(dict_of(std::move(figure)));
  py::dict dict;
  dict["title"] = std::string(study.title);
  dict["values"] = value_of_json(text::json_of_any_text(result.json, -1));
  dict["tables"] = std::move(tables);
  dict["figures"] = std::move(figures);
  return dict;
}

}  // namespace

void add_studies(py::module_& module) {
  using py::arg;
  module.def("study", &run_study, arg("name"), py::kw_only(), arg("runs"), arg("seed"), arg("jobs"),
             arg("cases"));
}

}  // namespace drydock::python
