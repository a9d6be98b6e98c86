#include <stdexcept>

#include "hil/compare/compare.hpp"
#include "hil/compare/contest.hpp"
#include "hil/track/played_capture.hpp"

namespace drydock::compare {
namespace {

measurement::Stamp heard_at(const measurement::Measurement& m) {
  return measurement::origin_of(m).received_at;
}

}  // namespace

Comparison compare_on_capture(const CompareOptions& options) {
  auto capture = options.capture;
  capture.capture = options.source;
  const auto made = track::rig_of_capture(capture, options.rig, options.part.only);
  const auto played = track::played_capture(made, options.part);
  if (played.measurements.empty())
    throw std::runtime_error(track::silence_of(capture, made, options.part));
  Comparison comparison;
  comparison.source = options.source;
  comparison.notes = played.notes;
  const auto start = heard_at(played.measurements.front());
  comparison.duration_s = measurement::seconds(heard_at(played.measurements.back()) - start);
  Contest contest(made.text, made.file.empty() ? made.rig.file : made.file, options.estimators,
                  {nullptr, start, comparison.duration_s});
  for (const auto& m : played.measurements) contest.on_measurement(m);
  contest.write(comparison);
  return comparison;
}

}  // namespace drydock::compare
