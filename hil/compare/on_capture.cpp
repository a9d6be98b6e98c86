#include <algorithm>
#include <iterator>
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
  const auto capture = track::one_capture(options);
  const auto made = track::rig_of_capture(capture.how, options.rig, options.part.only);
  const auto played = track::played_capture(made, options.part);
  if (played.measurements.empty())
    throw std::runtime_error(track::silence_of(capture, made, options.part));
  Comparison comparison;
  comparison.source = capture.shown;
  comparison.notes = capture.notes;
  std::ranges::copy(played.notes, std::back_inserter(comparison.notes));
  const auto start = heard_at(played.measurements.front());
  comparison.duration_s = measurement::seconds(heard_at(played.measurements.back()) - start);
  Contest contest(made.text, made.file.empty() ? made.rig.file : made.file, options.estimators,
                  {nullptr, start, comparison.duration_s});
  for (const auto& m : played.measurements) contest.on_measurement(m);
  contest.write(comparison);
  return comparison;
}

}  // namespace drydock::compare
