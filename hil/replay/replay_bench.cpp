#include "hil/replay/replay_bench.hpp"

#include <algorithm>
#include <stdexcept>

#include "drivers/bus/cdr/cdr_measurements.hpp"
#include "drivers/host/rig_bus.hpp"
#include "estimators/setup/rig_pipeline.hpp"

namespace drydock::replay {

namespace {

constexpr std::chrono::seconds health_period{1};  // as in a run
constexpr std::string_view faults_topic = "/drydock/faults", health_topic = "/diagnostics";
/// Nothing at all for so long is a hole of a recording whose links spoke lately.
constexpr std::chrono::milliseconds shortest_hole{2500};
constexpr std::chrono::seconds lately{10};

pipeline::Pipeline pipeline_of(const rig_config::Rig& rig, const setup::Outside* outside,
                               pipeline::EstimateListener& listener) {
  auto made = pipeline::make_pipeline(setup::pipeline_options(rig, outside), listener);
  if (!made) throw std::runtime_error(made.error().message);
  return std::move(*made);
}

std::unique_ptr<record::Player> player_of(const record::Recording& recording,
                                          const rig_config::Rig& rig, const record::Selection& part,
                                          device::Listener& listener) {
  auto made = record::Player::make(recording, rig, part, listener);
  if (!made) throw std::runtime_error(made.error().line);
  return std::move(*made);
}

measurement::Stamp time_of(const record::Event& event) {
  if (const auto* raw = std::get_if<record::RawEvent>(&event)) return raw->at();
  return std::get<record::Understood>(event).at;
}

}  // namespace

ReplayBench::ReplayBench(record::Recording& recording, const rig_config::Rig& rig,
                         const record::Selection& part, const ReplayOutlets& outlets,
                         const std::vector<rig_config::FaultConfig>& faults)
    : recording_(recording),
      rig_(rig),
      part_(part),
      outlets_(outlets),
      gate_(*this, rig.estimators.size()),
      teller_(gate_),
      pipeline_(pipeline_of(rig, outlets.outside, teller_)),
      start_(recording.begin().value_or(Stamp{}) + part.from.value_or(Stamp::duration{0})),
      next_health_(start_ + health_period),
      player_(player_of(recording, rig, part, gate_)),
      errors_(rig) {
  followers_.add(errors_);
  if (!faults.empty()) add_faults(faults);
}

void ReplayBench::add_faults(const std::vector<rig_config::FaultConfig>& faults) {
  std::vector<std::string> played;
  for (const auto& actor : player_->devices()) played.push_back(actor->device().name());
  faults_ = std::make_unique<ReplayFaults>(
      recording_, rig_, faults, played,
      ReplayFaults::Drivers{
          [this](const record::RawEvent& event) { hear(event); },
          [this](std::size_t link, bool there) { player_->set_port(link, there); }});
}

void ReplayBench::play(Pace& pace, const record::Watch& watch) {
  const Stamp begin = recording_.begin().value_or(Stamp{});
  Stamp last = start_;
  while (const auto event = recording_.next()) {
    if (!watch(recording_.done())) gate_.ended = true;
    if (gate_.ended) break;
    const Stamp at = time_of(*event);
    if (!part_.holds(at, begin)) continue;
    last = std::max(last, at);
    end_links_before(at);
    skip_hole(at);
    note_heard(*event, at);
    if (const auto* raw = std::get_if<record::RawEvent>(&*event)) {
      if (!part_.takes(recording_.links()[raw->link])) continue;
      if (!wait_until(at, pace)) break;
      play(*raw);
    } else {
      hear(std::get<record::Understood>(*event));
    }
  }
  // The replay does not run past the end of the recording: the record does not show what drivers
  // that still waited would have got.
  if (!gate_.ended) wait_until(last, pace);
  if (!gate_.ended) end_links_before(part_.to ? last : Stamp::max());
  pipeline_.flush();
  truth_.tell();
  if (outlets_.at_end) outlets_.at_end();
  gate_.stopping = true;
  player_->finish(player_->now());
}

/// A link has its last event at its end, so this is the first moment behind it.
void ReplayBench::end_links_before(Stamp at) {
  const auto& links = recording_.links();
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto end = outlets_.ends.find(links[i].uri);
    if (end == outlets_.ends.end() || end->second >= at) continue;
    player_->end_of_recording(i);
    outlets_.ends.erase(end);
  }
}

void ReplayBench::note_heard(const record::Event& event, Stamp at) {
  heard_ = at;
  if (const auto* raw = std::get_if<record::RawEvent>(&event)) {
    if (heard_of_link_.size() <= raw->link) heard_of_link_.resize(raw->link + 1U);
    heard_of_link_[raw->link] = at;
  } else {
    has_health_ |= std::get<record::Understood>(event).channel->topic == health_topic;
  }
}

/// Where a recording has nothing at all, its recorder stood still: the run told its health once a
/// second, and links do not fall silent together. Nobody tells health then.
void ReplayBench::skip_hole(Stamp at) {
  if (!heard_ || at - *heard_ < shortest_hole || at <= next_health_) return;
  const auto talked =
      std::ranges::count_if(heard_of_link_, [this](Stamp last) { return *heard_ - last < lately; });
  if (!has_health_ && talked < 2) return;
  next_health_ += ((at - next_health_) / health_period + 1) * health_period;
}

std::vector<const device::Device*> ReplayBench::devices() const {
  std::vector<const device::Device*> all;
  for (const auto& actor : player_->devices()) all.push_back(&actor->device());
  return all;
}

std::vector<std::pair<std::string, double>> ReplayBench::rates_hz() const {
  std::vector<std::pair<std::string, double>> rates;
  for (const auto* device : devices())
    rates.emplace_back(device->name(), device->health(player_->now()).rate_hz.value_or(0));
  return rates;
}

/// Time goes on from deadline to deadline: those of the drivers, those of the faults, and the
/// health report each second.
bool ReplayBench::wait_until(Stamp at, Pace& pace) {
  if (at - next_health_ > record::Player::longest_pause)
    next_health_ += (at - next_health_) / health_period * health_period;
  for (;;) {
    const Stamp of_faults = faults_ ? faults_->deadline().value_or(Stamp::max()) : Stamp::max();
    const Stamp next = std::max(std::min(next_health_, of_faults), player_->now());
    if (next > at) break;
    if (!pace.wait(next, interrupt_)) gate_.ended = true;
    if (gate_.ended) return false;
    player_->run_until(next);
    if (next_health_ <= of_faults) {
      tell_health();
      next_health_ += health_period;
    } else {
      faults_->tick(next);
    }
  }
  if (!pace.wait(at, interrupt_)) gate_.ended = true;
  if (gate_.ended) return false;
  player_->run_until(at);
  return true;
}

void ReplayBench::play(const record::RawEvent& event) {
  if (faults_ && faults_->are_on(event.link) && event.direction() == record::Direction::received)
    faults_->receive(event);
  else
    hear(event);
}

void ReplayBench::hear(const record::RawEvent& event) {
  const auto& link = recording_.links()[event.link];
  if (const auto* read = std::get_if<record::RawBytes>(&event.content))
    followers_.on_bytes(link.uri, read->direction, read->data, read->at);
  else
    followers_.on_frame(link.uri, event.direction(),
                        std::get<record::RawFrame>(event.content).frame, event.at());
  if (outlets_.onto != nullptr) outlets_.onto->send(event);
  player_->play(event);
}

/// Messages that no driver can reproduce: the truth and the injected faults.
void ReplayBench::hear(const record::Understood& message) {
  truth_.hear(message);
  if (message.channel->topic != faults_topic) return;
  if (const auto faults = bus::faults_of(message.cdr)) followers_.on_faults(*faults, message.at);
}

void ReplayBench::tell_health() {
  const Stamp now = player_->now();
  const host::HealthReport health([this, now] {
    host::HealthReport::Statuses statuses;
    for (const auto& actor : player_->devices())
      statuses.push_back(host::status_of(actor->device(), actor->device().health(now)));
    return statuses;
  });
  followers_.on_health(health, now);
  followers_.tick(now);
}

void ReplayBench::Gate::step() {
  if (bench_.outlets_.step && !ended && !bench_.outlets_.step(bench_.interrupt_)) ended = true;
}

void ReplayBench::Gate::on_measurement(const measurement::Measurement& measurement) {
  if (ended) return;
  ++measurements;
  bench_.followers_.on_measurement(measurement);
  step();
  bench_.pipeline_.receive(measurement);
}

void ReplayBench::Gate::on_state(const device::Device& device, const device::Transition& change) {
  if (!stopping) bench_.followers_.on_state(device, change);
}

void ReplayBench::Gate::on_estimate(const host::Estimate& estimate) {
  if (ended) return;
  ++estimates[estimate.estimator];
  bench_.followers_.on_estimate(estimate);
  step();
}

void ReplayBench::Gate::on_innovation(const bus::Innovation& innovation) {
  if (!ended) bench_.followers_.on_innovation(innovation);
}

}  // namespace drydock::replay
