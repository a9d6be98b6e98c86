#include "estimators/setup/rig_pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "drivers/measurement/stamp.hpp"
#include "estimators/setup/options_of.hpp"

namespace drydock::setup {

pipeline::PipelineOptions pipeline_options(const rig_config::Rig& rig, const Outside* outside) {
  pipeline::PipelineOptions options;
  options.reorder_window = measurement::from_seconds(rig.reorder_window_s);
  for (const auto& config : rig.estimators) {
    pipeline::EstimatorOptions estimator;
    estimator.name = config.name;
    estimator.imu = index_of(rig, config.imu).value_or(0);
    const EstimatorInRig place{rig, config, outside};
    estimator.kind = std::visit(
        [&](const auto& kind) -> pipeline::EstimatorKind { return options_of(kind, place); },
        config.kind);
    options.estimators.push_back(std::move(estimator));
  }
  return options;
}

std::vector<std::string> pipeline_notes(const rig_config::Rig& rig,
                                        const pipeline::Pipeline& pipeline) {
  std::vector<std::string> notes;
  const auto& counters = pipeline.counters();
  for (std::size_t i = 0; i < std::min(counters.size(), rig.devices.size()); ++i) {
    const pipeline::DeviceCounters& c = counters[i];
    if (c.left_out > 0)
      notes.push_back(fmt::format("{}: {} of {} measurements left out, because it was not sound",
                                  rig.devices[i].name, c.left_out, c.received));
    if (c.late == 0 && c.refused == 0) continue;
    notes.push_back(fmt::format("{}: of {} measurements {} too late for the estimators, {} refused",
                                rig.devices[i].name, c.received, c.late, c.refused));
  }
  for (std::size_t i = 0; i < std::min(pipeline.estimators(), rig.estimators.size()); ++i) {
    const auto status = pipeline.status(i);
    if (std::holds_alternative<rig_config::ExternalConfig>(rig.estimators[i].kind) &&
        pipeline.peer(i) == nullptr)
      notes.push_back(
          fmt::format("{}: another program, which was not asked; run asks it, and so does replay "
                      "with --rig if the rig has its command",
                      rig.estimators[i].name));
    if (status.rejected > 0)
      notes.push_back(
          fmt::format("{}: {} values outside its gate", rig.estimators[i].name, status.rejected));
    if (status.wild > 0 || status.steps > 0)
      notes.push_back(fmt::format(
          "{}: {} samples and {} steps of \"{}\" that no vehicle can cause, none of them followed",
          rig.estimators[i].name, status.wild, status.steps, rig.estimators[i].imu));
    if (status.restarts > 0)
      notes.push_back(
          fmt::format("{}: started again {} times, after a silence or a fault of its IMU, or a "
                      "clock that was set "
                      "back",
                      rig.estimators[i].name, status.restarts));
    if (status.divergences > 0)
      notes.push_back(
          fmt::format("{}: started again {} times, because its innovations contradicted it",
                      rig.estimators[i].name, status.divergences));
    if (status.bridged > 0)
      notes.push_back(fmt::format(
          "{}: {} gaps without speed or heading bridged, {:.1f} s in all, the longest {:.1f} s",
          rig.estimators[i].name, status.bridged, status.bridged_s, status.longest_bridged_s));
    if (status.lost_at)
      notes.push_back(fmt::format(
          "{}: lost after {} estimates, when its IMU fell silent for more than {} s; it needs a "
          "new start",
          rig.estimators[i].name, status.estimates,
          measurement::seconds(pipeline::PipelineOptions{}.max_imu_gap)));
  }
  if (pipeline.overflows() > 0) {
    notes.push_back(fmt::format("reorder buffer full: {} measurements used before their turn",
                                pipeline.overflows()));
  }
  return notes;
}

}  // namespace drydock::setup
