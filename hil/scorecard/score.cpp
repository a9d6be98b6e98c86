#include "hil/scorecard/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hil/scorecard/detection.hpp"
#include "hil/scorecard/wrong_numbers.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::scorecard {
namespace {

/// Messages of the last moments may not have arrived yet.
constexpr double tail_s = 2.5;

std::int64_t arrivals_from(const DeviceRecord& device, double from_s) {
  return std::ranges::count_if(
      device.arrivals, [&](const Arrival& arrival) { return arrival.received_s >= from_s; });
}

/// The time of the last number of the reference run that this run lacks or has wrong.
double last_unsound_s(std::size_t device, std::uint32_t key, const Series& usual,
                      const Reference& reference, const DeviceRecord& now, const Window& window) {
  std::vector<Sample> got;
  if (const auto found = now.series.find(key); found != now.series.end())
    got = found->second.samples;
  std::ranges::stable_sort(got, {}, &Sample::valid_s);
  const double reach = 0.75 * reference.period_s(device, key);
  const auto has_counterpart = [&](const Sample& wanted) {
    auto first = std::ranges::lower_bound(got, wanted.valid_s - reach, {}, &Sample::valid_s);
    for (; first != got.end() && first->valid_s <= wanted.valid_s + reach; ++first)
      if (reference.sound(device, key, *first)) return true;
    return false;
  };
  for (auto sample = usual.samples.rbegin(); sample != usual.samples.rend(); ++sample) {
    if (sample->received_s < window.fault_end_s()) break;
    if (sample->received_s < window.run_s() - tail_s && !has_counterpart(*sample))
      return sample->received_s;
  }
  return window.fault_end_s();
}

std::optional<double> recovery_s(const Pair& pair, const Reference& reference, const RunRecord& run,
                                 const Window& window) {
  const std::size_t device = pair.device;
  double unsound_s = window.fault_end_s();
  const DeviceRecord& now = run.devices[device];
  for (const auto& [key, usual] : reference.run().devices[device].series)
    if (blame_for(usual.role, pair.fault) != Blame::nobody)
      unsound_s = std::max(unsound_s, last_unsound_s(device, key, usual, reference, now, window));
  const double last_chance_s = window.run_s() - tail_s;
  for (const Arrival& arrival : now.arrivals)
    if (arrival.received_s > unsound_s && arrival.received_s < window.run_s()) {
      if (unsound_s > window.fault_end_s() && last_chance_s - unsound_s < tail_s) return {};
      return arrival.received_s - window.fault_end_s();
    }
  return {};
}

/// The longest time in a row in which an estimate was valid and wrong.
class WrongWhileValid {
 public:
  void add(const ErrorAt& error) {
    constexpr double wrong_sigmas = 5;
    const bool wrong = error.valid && !(error.sigmas <= wrong_sigmas);
    if (!wrong) right_s_ = error.at_s;
    longest_s_ = std::max(longest_s_, error.at_s - right_s_);
  }
  double longest_s() const { return longest_s_; }

 private:
  double right_s_ = std::numeric_limits<double>::infinity();  ///< the last time it was not
  double longest_s_ = 0;
};

EstimatorScore score_estimator(const std::string& name, const std::vector<ErrorAt>& usual,
                               const std::vector<ErrorAt>& now, const Window& window) {
  EstimatorScore score;
  score.name = name;
  std::int64_t expected = 0, got = 0, valid = 0, usually_valid = 0;
  double usual_nees = 0;
  const auto largest = [](std::optional<double>& most, const std::optional<double>& x) {
    if (x) most = std::max(most.value_or(0), *x);
  };
  for (const ErrorAt& error : usual) {
    if (error.at_s < window.warm_up_s) continue;
    ++expected;
    if (error.valid) {
      ++usually_valid;
      usual_nees += error.nees;
    }
    score.usual_deg = std::max(score.usual_deg, error.tilt_deg);
    largest(score.usual_m, error.horizontal_m);
  }
  // An estimate is sound if its error is at most 1.5 times the largest error without faults.
  constexpr double sound_share = 1.5;
  double nees = 0, unsound_s = window.fault_end_s(), last_s = 0;
  WrongWhileValid wrong;
  for (const ErrorAt& error : now) {
    if (error.at_s < window.warm_up_s) continue;
    ++got;
    wrong.add(error);
    if (error.valid) {
      ++valid;
      nees += error.nees;
    }
    last_s = error.at_s;
    score.error_deg = std::max(score.error_deg, error.tilt_deg);
    largest(score.horizontal_m, error.horizontal_m);
    if (error.tilt_deg > sound_share * score.usual_deg ||
        error.horizontal_m.value_or(0) > sound_share * score.usual_m.value_or(0))
      unsound_s = std::max(unsound_s, error.at_s);
  }
  score.lost = expected - got;
  if (usually_valid > 0) score.usual_nees = usual_nees / static_cast<double>(usually_valid);
  if (valid > 0) score.nees = nees / static_cast<double>(valid);
  if (got > 0) score.valid_share = static_cast<double>(valid) / static_cast<double>(got);
  score.wrong_while_valid_s = wrong.longest_s();
  if (last_s > window.run_s() - tail_s && unsound_s < window.run_s() - tail_s)
    score.recover_s = unsound_s - window.fault_end_s();
  return score;
}

/// "probability = 0.2" from "dvl: drop, probability = 0.2".
std::string amount_of(const rig_config::FaultConfig& fault) {
  const auto comma = fault.words.find(", ");
  return comma == std::string::npos ? "" : fault.words.substr(comma + 2);
}

}  // namespace

Score score_of(const rig_config::Rig& rig, const Window& window, const Pair& pair,
               const Reference& reference, const RunRecord& run) {
  Score score;
  score.device = rig.devices[pair.device].name;
  score.fault = pair.label;
  score.amount = amount_of(pair.fault);
  score.layer = rig_config::name_of(rig_config::word_of(pair.fault.kind).layer);
  if (const auto sign = first_sign(pair.device, window, reference, run)) {
    score.detect_s = sign->at_s - window.warm_up_s;
    score.sign = sign->what;
  }
  score.finding = judge_findings(rig, window, pair, reference.run().findings, run);
  score.recover_s = recovery_s(pair, reference, run, window);
  for (std::size_t i = 0; i < run.devices.size(); ++i)
    (i == pair.device ? score.lost : score.others_lost) +=
        arrivals_from(reference.run().devices[i], window.warm_up_s) -
        arrivals_from(run.devices[i], window.warm_up_s);
  const WrongNumbers wrong = wrong_numbers(rig, window, pair, reference, run);
  score.wrong = wrong.of_driver;
  score.mistimed = wrong.mistimed;
  score.lies = wrong.of_sensor;
  score.example = wrong.example;
  for (std::size_t i = 0; i < rig.estimators.size(); ++i)
    if (!reference.run().estimators[i].empty())
      score.estimators.push_back(score_estimator(
          rig.estimators[i].name, reference.run().estimators[i], run.estimators[i], window));
  return score;
}

}  // namespace drydock::scorecard
