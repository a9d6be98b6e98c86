#include "drivers/diagnosis/monitors/value_monitor.hpp"

#include <algorithm>
#include <cmath>

namespace drydock::diagnosis {
namespace {

/// Values that came nearly always in the first time are missed when they stay away.
constexpr double usual_presence = 0.95;
constexpr unsigned fewest_messages = 30, fewest_missing = 3;
constexpr std::chrono::milliseconds shortest_absence{800};
constexpr std::chrono::seconds presence_learning{45};
/// A receiver needs so long for its satellites after a dive.
constexpr std::chrono::seconds back_after_dive{10};
/// A step is told for so long if it does not go back.
constexpr std::chrono::seconds step_lasts{60};
/// A jump that ends a fault of the values is their return.
constexpr std::chrono::seconds returns{2};
/// Wild samples farther apart have nothing to do with each other.
constexpr std::chrono::seconds wild_memory{20};
/// The largest of equal errors is at most so many times the smallest.
constexpr double alike = 1.5;

/// An inertial unit has no grade here: the vibration of its vehicle is stronger than its noise.
double grade_of(const Expected& expected, Quantity quantity) {
  switch (quantity) {
    case Quantity::bottom_x:
    case Quantity::bottom_y:
    case Quantity::bottom_z:
    case Quantity::log_x:
    case Quantity::log_y:
    case Quantity::pressure:
    case Quantity::north:
    case Quantity::east: return expected.noise;
    case Quantity::velocity_north:
    case Quantity::velocity_east: return expected.second_noise;
    default: return 0;
  }
}

}  // namespace

ValueMonitor::ValueMonitor(const Expected& expected, SymptomSink& to)
    : expected_(expected), teller_(expected.device, to), satellites_(expected.device, to) {}

ValueMonitor::Stream* ValueMonitor::stream_of(std::uint32_t kind) {
  const auto known = std::ranges::find(streams_, kind, &Stream::kind);
  if (known != streams_.end()) return &*known;
  if (streams_.size() == streams_.capacity()) return nullptr;
  streams_.emplace_back().kind = kind;
  return &streams_.back();
}

QuantityMonitor* ValueMonitor::monitor_of(Quantity quantity) {
  for (QuantityMonitor& monitor : monitors_)
    if (monitor.quantity() == quantity) return &monitor;
  if (monitors_.size() == monitors_.capacity()) return nullptr;
  return &monitors_.emplace_back(quantity, grade_of(expected_, quantity));
}

bool ValueMonitor::take(std::uint32_t kind, const measurement::Measurement& measurement) {
  const Stamp at = measurement::origin_of(measurement).received_at;
  if (const auto* satellites = std::get_if<measurement::GnssSatellites>(&measurement)) {
    judge_sky(*satellites);
    return false;
  }
  Stream* const stream = stream_of(kind);
  if (stream == nullptr) return false;
  const Readings readings = readings_of(measurement, home_);
  judge_presence(*stream, !readings.empty(), at);
  if (readings.empty()) return false;
  const bool same = judge_run(stream->whole, readings, at);
  if (expected_.kind == measurement::Kind::imu) judge_halves(*stream, readings, at);
  for (const Reading& reading : readings) judge(reading, at);
  return same;
}

/// Where nobody knows where the antenna is, a sky of which nothing is left may be a dive.
void ValueMonitor::judge_sky(const measurement::GnssSatellites& sky) {
  const Stamp now = sky.origin.received_at;
  const bool dark = std::ranges::none_of(sky.satellites, [](const measurement::Satellite& one) {
    return one.cno_dbhz.value_or(0) > 0;
  });
  if (antenna_ == Antenna::wet || (antenna_ == Antenna::unknown && dark)) wet_until_ = now;
  if (!may_have_dived(now)) satellites_.take(sky);
}

bool ValueMonitor::may_have_dived(Stamp now) const { return now - wet_until_ < back_after_dive; }

void ValueMonitor::judge(const Reading& reading, Stamp at) {
  QuantityMonitor* const monitor = monitor_of(reading.quantity);
  if (monitor == nullptr) return;
  const auto news = monitor->add(reading.value, at);
  if (!monitor->known()) return;
  pulses_.add(news.pulse != 0, at);
  if (news.wild != 0)
    tell_wild(*monitor, news.wild, at);
  else if (news.pulse != 0 && pulses_.fired())
    tell_wild(*monitor, news.pulse, at);
  if (news.jump != 0) tell_jump(*monitor, news, at);
  if (news.coarse != 0)
    teller_.tell(Sign::coarse, monitor->resolution().since(), at,
                 {news.coarse, monitor->resolution().step(), facts_of(reading.quantity).name,
                  facts_of(reading.quantity).unit});
  if (news.noisy) returns_until_ = at + returns;
  if (news.noisy)
    teller_.tell(Sign::noisy, monitor->noise().since(), at,
                 {monitor->noise().sum(), QuantityMonitor::noise_threshold,
                  facts_of(reading.quantity).name, "log-likelihood"});
}

void ValueMonitor::tell_wild(const QuantityMonitor& monitor, double off, Stamp at) {
  const auto& facts = facts_of(monitor.quantity());
  if (at - wild_at_ > wild_memory) wild_.clear();
  if (wild_.size() == wild_.capacity()) wild_.erase(wild_.begin());
  wild_.push_back({monitor.quantity(), std::abs(off)});
  wild_at_ = at;
  jumped_.since.reset();
  teller_.tell(Sign::wild_samples, at, at, {off, facts.wild, facts.name, facts.unit});
  const auto [least, most] = std::ranges::minmax(wild_, {}, &Reading::value);
  const bool one = std::ranges::all_of(
      wild_, [&](const Reading& r) { return r.quantity == wild_.front().quantity; });
  constexpr std::size_t fewest = 3;
  const bool unequal = wild_.size() >= fewest && (!one || most.value > alike * least.value);
  if (unequal && expected_.protocol.checksum.empty())
    teller_.tell(Sign::wild_unequal, at, at, {off, facts.wild, facts.name, facts.unit});
}

void ValueMonitor::tell_jump(const QuantityMonitor& monitor, const QuantityMonitor::News& news,
                             Stamp at) {
  const bool back =
      jumped_.since && jumped_.quantity == monitor.quantity() && jumped_.by * news.jump < 0;
  if (back) return jumped_.since.reset();
  if (at < returns_until_) return;
  jumped_ = {at, monitor.quantity(), news.jump, news.most};
}

/// The gyros of an IMU can stand still while its accelerometers go on, and the other way about.
void ValueMonitor::judge_halves(Stream& stream, const Readings& readings, Stamp at) {
  const auto middle = readings.begin() + static_cast<std::ptrdiff_t>(readings.size() / 2);
  judge_run(stream.halves[0], Readings(readings.begin(), middle), at);
  judge_run(stream.halves[1], Readings(middle, readings.end()), at);
}

/// True if the values are those of the message before.
bool ValueMonitor::judge_run(Run& run, const Readings& readings, Stamp at) {
  const Sameness& sameness = run.sameness;
  const bool same = run.sameness.add(readings, at);
  if (sameness.run() == 1) run.elsewhere = jumped(sameness.before_run(), readings);
  const auto impossible = sameness.impossible_run();
  if (!impossible || sameness.run() < *impossible || !noise_shows(readings)) return same;
  returns_until_ = at + returns;
  const Amount amount{static_cast<double>(sameness.run()), static_cast<double>(*impossible),
                      "equal messages in a row", ""};
  teller_.tell(run.elsewhere ? Sign::out_of_range : Sign::stuck, sameness.run_since(), at, amount);
  return same;
}

bool ValueMonitor::noise_shows(const Readings& readings) {
  return std::ranges::any_of(readings, [&](const Reading& reading) {
    const QuantityMonitor* const monitor = monitor_of(reading.quantity);
    return monitor != nullptr && monitor->noise_shows();
  });
}

bool ValueMonitor::jumped(const Readings& from, const Readings& to) {
  for (std::size_t i = 0; i < std::min(from.size(), to.size()); ++i) {
    const QuantityMonitor* const monitor = monitor_of(to[i].quantity);
    if (monitor != nullptr && std::abs(from[i].value - to[i].value) > monitor->usual_change())
      return true;
  }
  return false;
}

void ValueMonitor::judge_presence(Stream& stream, bool has_values, Stamp at) {
  if (!stream.first) stream.first = at;
  if (at - *stream.first < presence_learning || stream.count < fewest_messages) {
    ++stream.count;
    stream.with_values += has_values ? 1 : 0;
    return;
  }
  if (has_values)
    stream.missing_run = 0;
  else if (stream.missing_run++ == 0)
    stream.missing_since = at;
  const bool excused =
      expected_.kind == measurement::Kind::gnss && (antenna_ != Antenna::dry || may_have_dived(at));
  const bool usual = stream.with_values > usual_presence * stream.count;
  if (excused || !usual || stream.missing_run < fewest_missing ||
      at - stream.missing_since < shortest_absence)
    return;
  const bool no_fix = expected_.kind == measurement::Kind::gnss;
  teller_.tell(
      no_fix ? Sign::satellites_gone : Sign::values_missing, stream.missing_since, at,
      {static_cast<double>(stream.missing_run), fewest_missing, "messages without a value", ""});
}

void ValueMonitor::look(Stamp now) {
  if (!jumped_.since) return;
  if (now - *jumped_.since > step_lasts) return jumped_.since.reset();
  const auto& facts = facts_of(jumped_.quantity);
  teller_.tell(Sign::step, *jumped_.since, now, {jumped_.by, jumped_.most, facts.name, facts.unit});
}

void ValueMonitor::set_antenna(Antenna antenna, Stamp now) {
  if (antenna_ == Antenna::wet) wet_until_ = now;
  if (antenna_ == Antenna::unknown && antenna == Antenna::dry) wet_until_ = {};  // it was no dive
  antenna_ = antenna;
}

void ValueMonitor::interrupt() {
  for (QuantityMonitor& monitor : monitors_) monitor.interrupt();
  for (Stream& stream : streams_) {
    stream.whole.sameness.interrupt();
    for (Run& half : stream.halves) half.sameness.interrupt();
  }
}

}  // namespace drydock::diagnosis
