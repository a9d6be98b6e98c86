#include "hil/endurance/soak_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/diagnosis/finding_words.hpp"
#include "drivers/diagnosis/surroundings.hpp"
#include "drivers/text/measurement_fields.hpp"
#include "hil/fault/injector.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::endurance {

namespace {

constexpr std::size_t most_troubles = 100;

bool is_number(double value) { return std::isfinite(value); }
bool is_number(const Eigen::Vector3d& value) { return value.allFinite(); }
template <class T>
bool is_number(const std::optional<T>& value) {
  return !value || is_number(*value);
}
template <class T>
bool is_number(const T&) {  // words, counts and lists hold no NaN
  return true;
}

/// A fault of the whole bus affects every device on it.
bool is_of_the_bus(rig_config::FaultKind kind) {
  return rig_config::word_of(kind).facts.needs == rig_config::FaultNeed::can_bus;
}

}  // namespace

SoakWatch::SoakWatch(const rig_config::Rig& rig, std::uint64_t seed,
                     std::optional<double> fault_interval_s, double rest_s)
    : rig_(rig),
      rest_s_(rest_s),
      start_(measurement::stamp_from_ns(rig.start_utc_ns)),
      trouble_until_(rig.devices.size(), start_ + recovers_within),
      fault_until_(start_ - std::chrono::nanoseconds{1}),
      last_tick_(start_) {
  if (!fault_interval_s) return;
  faults_.emplace(rig, seed, *fault_interval_s);
  take_next();
}

/// The random faults know no rests; their times are those of the bursts, one behind the other.
void SoakWatch::take_next() {
  next_ = faults_->next();
  next_->start_s += std::floor(next_->start_s / burst_s) * rest_s_;
}

void SoakWatch::tick(Stamp now) {
  set_faults(now);
  for (std::size_t i = 0; i < bench_->devices.size(); ++i) look_at(i, now);
  count_quiet(now);
  if (rest_s_ > 0 && quiet(now)) look_at_what_stays(now);
  ++looks_;
}

/// Tells each finding once, whatever better words it gets later.
void SoakWatch::look_at_what_stays(Stamp now) {
  for (auto& [device, one] : staying_) {
    if (std::exchange(one.told, true)) continue;
    ++false_alarms_;
    const auto account = diagnosis::account_of(one.finding, rig_.devices.at(device).name, start_);
    add(fmt::format("still found at {:.0f} s: {}", measurement::seconds(now - start_),
                    diagnosis::line_of(account)));
  }
}

/// The faults of the rig and its mission count as those that the watch sets.
void SoakWatch::count_quiet(Stamp now) {
  if (!bench_->faults.in_force(now).empty())
    fault_until_ = std::max(fault_until_, now + recovers_within);
  if (quiet(now)) quiet_s_ += measurement::seconds(now - last_tick_);
  last_tick_ = now;
}

void SoakWatch::on_finding(const diagnosis::Finding& finding) {
  if (finding.until) {
    staying_.erase(finding.device);
    return;
  }
  ++findings_;
  const bool of_surroundings = diagnosis::is_of_the_surroundings(finding.cause);
  if (of_surroundings) {
    ++of_surroundings_;
    return;
  }
  if (!quiet(finding.found) || !bench_->faults.in_force(finding.found).empty()) {
    staying_[finding.device].finding = finding;
    return;
  }
  ++false_alarms_;
  const auto account = diagnosis::account_of(finding, rig_.devices.at(finding.device).name, start_);
  add("false alarm: " + diagnosis::line_of(account));
}

void SoakWatch::set_faults(Stamp now) {
  while (next_ && start_ + measurement::from_seconds(next_->start_s) <= now) {
    rig_config::FaultConfig fault = *next_;
    fault.start_s = 0;
    if (const auto set = bench_->faults.set(fault, now); !set) add(to_string(set.error().front()));
    ++faults_set_;
    ++by_word_[std::string(rig_config::word_of(next_->kind).name)];
    const auto until = now + measurement::from_seconds(*next_->for_s) + recovers_within;
    const auto victim =
        std::ranges::find(rig_.devices, next_->device, &rig_config::DeviceConfig::name);
    for (std::size_t i = 0; i < rig_.devices.size(); ++i) {
      const bool hit = rig_.devices[i].name == next_->device ||
                       (is_of_the_bus(next_->kind) && rig_.devices[i].link == victim->link);
      if (hit) trouble_until_[i] = std::max(trouble_until_[i], until);
    }
    fault_until_ = std::max(fault_until_, until);
    take_next();
  }
}

void SoakWatch::look_at(std::size_t index, Stamp now) {
  const device::Device& device = *bench_->devices[index];
  const auto vitals = device.vitals();
  const auto& stream = vitals.stream;
  const auto accounted = stream.bytes_good + stream.bytes_skipped + vitals.held_bytes;
  const double t = measurement::seconds(now - start_);
  if (stream.bytes_in != accounted)
    add(fmt::format("{:.0f} s: {} had {} bytes in, {} are accounted for", t, device.name(),
                    stream.bytes_in, accounted));
  if (now > trouble_until_[index] && vitals.state != device::State::streaming) {
    add(fmt::format("{:.0f} s: {} is {}, {} s after its last fault: {}", t, device.name(),
                    device::to_string(vitals.state), recovers_within.count(),
                    device.health(now).status.view()));
    trouble_until_[index] = now + recovers_within;  // reports this only once
  }
}

void SoakWatch::on_measurement(const measurement::Measurement& measurement) {
  std::visit(
      [&](const auto& m) {
        visit_fields(m, [&](std::string_view field, const auto& value) {
          if (!is_number(value))
            add(fmt::format("{}: {} is no number", rig_.devices.at(m.origin.device).name, field));
        });
      },
      measurement);
}

void SoakWatch::add(std::string trouble) {
  if (troubles_.size() < most_troubles) troubles_.push_back(std::move(trouble));
}

}  // namespace drydock::endurance
