#include <fstream>
#include <iterator>

#include "hil/bench/run.hpp"
#include "hil/compare/compare.hpp"
#include "hil/compare/contest.hpp"
#include "hil/compare/true_places.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::compare {

Comparison compare_on_rig(const rig_config::Rig& rig, const CompareOptions& options) {
  const auto start = measurement::stamp_from_ns(rig.start_utc_ns);
  const auto truth = motion::make_trajectory(rig.mission, start);
  const double duration_s =
      options.duration_s > 0 ? options.duration_s : measurement::seconds(truth->end() - start);
  Comparison comparison;
  comparison.source = options.source.capture;
  comparison.truth = summary::no_real_device(rig);
  std::ifstream in(rig.file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Contest contest(text, rig.file, options.estimators,
                  {comparison.truth ? truth.get() : nullptr, start, duration_s});
  rig_config::Rig devices = rig;
  devices.estimators.clear();
  devices.expects.clear();
  bench::RunOptions run;
  run.duration_s = duration_s;
  run.lockstep = run.quiet = true;
  run.followers = {&contest};
  comparison.duration_s = bench::run_lockstep(devices, run).duration_s;
  if (comparison.truth)
    comparison.true_places =
        true_places(*truth, start + measurement::from_seconds(comparison.duration_s));
  contest.write(comparison);
  return comparison;
}

}  // namespace drydock::compare
