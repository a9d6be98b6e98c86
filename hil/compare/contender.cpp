#include "hil/compare/contender.hpp"

#include <limits>
#include <stdexcept>

#include "estimators/setup/rig_pipeline.hpp"

namespace drydock::compare {
namespace {

constexpr double map_points = 1500;

/// Virtual time waits for an estimator in another program.
pipeline::Pipeline pipeline_of(const rig_config::Rig& rig, pipeline::EstimateListener& listener) {
  const setup::Outside outside{.lockstep = true};
  auto made = pipeline::make_pipeline(setup::pipeline_options(rig, &outside), listener);
  if (!made) throw std::runtime_error(made.error().message);
  return std::move(*made);
}

std::uint64_t used_of(const pipeline::Pipeline& pipeline) {
  std::uint64_t used = 0;
  for (const auto& device : pipeline.counters()) used += device.accepted + device.delayed;
  return used;
}

}  // namespace

double Entry::cost_us() const {
  return used > 0 ? 1e6 * cpu_s / static_cast<double>(used)
                  : std::numeric_limits<double>::quiet_NaN();
}

Contender::Contender(std::string choice, rig_config::Rig rig, const Setting& setting)
    : choice_(std::move(choice)),
      rig_(std::move(rig)),
      pipeline_(pipeline_of(rig_, outputs_)),
      sound_devices_(rig_, pipeline_),
      teller_(*this),
      scribe_(rig_, setting.truth, setting.start, setting.expected_s),
      place_spacing_(measurement::from_seconds(setting.expected_s / map_points)) {}

void Contender::take(const measurement::Measurement& measurement) {
  stopwatch_.start();
  pipeline_.receive(measurement);
  stopwatch_.stop();
  pass_on();
}

void Contender::finish() {
  stopwatch_.start();
  pipeline_.flush();
  stopwatch_.stop();
  pass_on();
}

void Contender::pass_on() {
  for (const auto& output : outputs_.all) {
    if (const auto* attitude = std::get_if<pipeline::AttitudeEstimate>(&output))
      teller_.on_attitude(*attitude);
    else
      teller_.on_navigation(std::get<pipeline::NavigationEstimate>(output));
  }
  outputs_.all.clear();
}

void Contender::on_estimate(const host::Estimate& estimate) {
  scribe_.on_estimate(estimate);
  const auto at = estimate.attitude.valid_at;
  if (estimate.integrity.valid) valid_at_.push_back(at);
  if (!estimate.navigation || at < next_place_) return;
  next_place_ = at + place_spacing_;
  const auto& n = *estimate.navigation;
  places_.push_back({n.latitude_rad, n.longitude_rad, n.height_m});
}

Entry Contender::entry() const {
  summary::Summary made;
  scribe_.write(made);
  const auto status = pipeline_.status(0);
  Entry entry;
  entry.choice = choice_;
  entry.summary = made.estimators.front();
  entry.summary.rejected = status.rejected;
  entry.summary.nis = status.taken.mean();
  entry.summary.valid_share = pipeline::valid_share({}, status);
  if (const auto* peer = pipeline_.peer(0)) entry.summary.program = *peer;
  entry.used = used_of(pipeline_);
  entry.cpu_s = stopwatch_.total_s();
  entry.gaps = gaps_of(valid_at_);
  entry.attitude = made.traces.front();
  entry.navigation = made.navigation.front();
  entry.places = places_;
  entry.notes = setup::pipeline_notes(rig_, pipeline_);
  return entry;
}

}  // namespace drydock::compare
