// Which of three speeds was off from the start on. docs/estimators/consistency.md
#include "estimators/consistency/speeds.hpp"

namespace drydock::consistency {

/// By the offsets that they had from the start: tests that fire keep them.
std::optional<double> Speeds::dvl_over_receiver() const {
  const auto offset_of = [&](const std::vector<std::size_t>& kind) -> std::optional<double> {
    if (kind.empty() || kind[0] >= Group::most) return {};
    const Test& test = group_.witnesses()[kind[0]].test;
    return test.learned() ? std::optional(test.offset()) : std::nullopt;
  };
  const auto dvl = offset_of(dvls_), receiver = offset_of(receivers_);
  return dvl && receiver ? std::optional(*dvl - *receiver) : std::nullopt;
}

/// Of the first DVL, receiver and log. What was learned of the water with a log that was off begins
/// anew.
void Speeds::judge_offset(Stamp at) {
  if (!first_) first_ = at;
  const bool was_log = is_log_off();
  const auto over_receiver = dvl_over_receiver();
  off_ = over_receiver ? first_offset(*over_receiver, off_currents_[0].offset(),
                                      off_currents_[0].offset_sigma())
                       : std::nullopt;
  if (!is_log_off() || was_log) return;
  currents_[0] = off_currents_[0];
  group_.restart(logs_[0]);
  forget_shafts();
}

bool Speeds::is_log_off() const { return off_ && off_->of == FirstOffset::Of::log; }

std::optional<std::uint16_t> Speeds::dvl_off() const {
  const bool off = off_ && off_->of == FirstOffset::Of::dvl;
  return off ? std::optional(tracks_.dvls[0].device) : std::nullopt;
}

void Speeds::tell(Stamp now, diagnosis::SymptomSink& to) const {
  if (!off_) return;
  using Of = FirstOffset::Of;
  const bool of_log = off_->of == Of::log;
  to.see({.device = of_log                ? tracks_.logs[0].device
                    : off_->of == Of::dvl ? tracks_.dvls[0].device
                                          : tracks_.receivers[0].device,
          .sign = diagnosis::Sign::offset,
          .since = *first_,
          .at = now,
          .value = off_->off_mps,
          .limit = of_log ? FirstOffset::least_of_log_mps : FirstOffset::least_mps,
          .quantity = of_log ? "speed through the water from the start" : "speed from the start",
          .unit = "m/s"});
}

}  // namespace drydock::consistency
