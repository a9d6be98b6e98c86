#include "hil/replay/replay_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "drivers/link/uri.hpp"
#include "drivers/measurement/earlier.hpp"
#include "hil/fault/wire/faulty_bus.hpp"
#include "hil/fault/wire/faulty_stream.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::replay {

using fault::FaultyBus;
using fault::FaultyStream;

/// Takes bytes and frames from the recording, or from the faults of another device on the same bus.
class ReplayFaults::Stage : public fault::Outlet {
 public:
  Stage(std::string device, fault::Outlet& next) : device_(std::move(device)), next_(next) {}

  void pass(wire::Bytes bytes, Stamp at) override { next_.pass(bytes, at); }
  void pass(const wire::CanFrame& frame, Stamp at) override { next_.pass(frame, at); }
  void set_port(bool there, Stamp at) override { next_.set_port(there, at); }
  virtual std::optional<Stamp> deadline() const = 0;
  virtual void tick(Stamp now) = 0;
  virtual fault::FaultHits hits() const = 0;
  const std::string& device() const { return device_; }

 protected:
  fault::Outlet& next() { return next_; }

 private:
  std::string device_;
  fault::Outlet& next_;
};

namespace {

template <class Faults>
class StageOf final : public ReplayFaults::Stage {
 public:
  template <class... Arguments>
  StageOf(std::string device, fault::Outlet& next, Arguments&&... arguments)
      : Stage(std::move(device), next), faults_(std::forward<Arguments>(arguments)...) {}

  void pass(wire::Bytes bytes, measurement::Stamp at) override {
    if constexpr (std::is_same_v<Faults, FaultyStream>) faults_.receive(bytes, at, next());
  }
  void pass(const wire::CanFrame& frame, measurement::Stamp at) override {
    if constexpr (std::is_same_v<Faults, FaultyBus>) faults_.receive(frame, at, next());
  }
  std::optional<measurement::Stamp> deadline() const override { return faults_.deadline(); }
  void tick(measurement::Stamp now) override { faults_.tick(now, next()); }
  fault::FaultHits hits() const override { return faults_.hits(); }

 private:
  Faults faults_;
};

void check(const rig_config::Rig& rig, const std::vector<std::string>& played) {
  if (const auto problems = check_faults_of(rig, rig_config::FaultTarget::replayed);
      !problems.empty())
    rig_config::throw_exception_from_error(problems, BOOST_CURRENT_LOCATION);
  for (const auto& fault : rig.faults)
    if (std::ranges::find(played, fault.device) == played.end())
      throw std::runtime_error(
          fmt::format("{}:{}:1: /fault: the replay does not play the device \"{}\"", fault.file,
                      fault.line, fault.device));
}

}  // namespace

class ReplayFaults::End final : public fault::Outlet {
 public:
  End(std::size_t link, const Drivers& drivers) : link_(link), drivers_(drivers) {}

  void pass(wire::Bytes bytes, Stamp at) override {
    drivers_.hear({link_, record::RawBytes{at, record::Direction::received, bytes}});
  }
  void pass(const wire::CanFrame& frame, Stamp at) override {
    drivers_.hear({link_, record::RawFrame{at, record::Direction::received, frame}});
  }
  void set_port(bool there, Stamp) override { drivers_.set_port(link_, there); }

 private:
  std::size_t link_;
  const Drivers& drivers_;
};

ReplayFaults::ReplayFaults(const record::Recording& recording, const rig_config::Rig& rig,
                           const std::vector<rig_config::FaultConfig>& faults,
                           const std::vector<std::string>& played, Drivers drivers)
    : rig_(rig), drivers_(std::move(drivers)), first_(recording.links().size()) {
  rig_.faults = faults;
  check(rig_, played);
  const Stamp start = recording.begin().value_or(Stamp{});
  schedules_.emplace(rig_, start, rig_config::FaultTarget::replayed);
  for (std::size_t link = 0; link < first_.size(); ++link) add(recording, link, start);
}

ReplayFaults::~ReplayFaults() = default;

/// Adds a stage for each device of the link that has faults. The recording feeds the first stage.
void ReplayFaults::add(const record::Recording& recording, std::size_t link, Stamp start) {
  const auto& recorded = recording.links()[link];
  const auto uri = link::parse_uri(recorded.uri);
  fault::Outlet* next = nullptr;
  for (const auto& device : rig_.devices) {
    const bool is_hit = std::ranges::find(rig_.faults, device.name,
                                          &rig_config::FaultConfig::device) != rig_.faults.end();
    if (!is_hit || std::ranges::find(recorded.devices, device.name) == recorded.devices.end())
      continue;
    if (!next) next = ends_.emplace_back(std::make_unique<End>(link, drivers_)).get();
    const auto& schedule = schedules_->of(device.name);
    if (recorded.frames)
      stages_.push_back(std::make_unique<StageOf<FaultyBus>>(device.name, *next, device,
                                                             uri ? uri->bitrate().value_or(0) : 0,
                                                             rig_.seed, schedule, start));
    else
      stages_.push_back(std::make_unique<StageOf<FaultyStream>>(device.name, *next, device,
                                                                rig_.seed, schedule, start));
    next = first_[link] = stages_.back().get();
  }
}

void ReplayFaults::receive(const record::RawEvent& event) {
  Stage& stage = *first_[event.link];
  if (const auto* read = std::get_if<record::RawBytes>(&event.content))
    stage.pass(read->data, read->at);
  else
    stage.pass(std::get<record::RawFrame>(event.content).frame, event.at());
}

std::optional<measurement::Stamp> ReplayFaults::deadline() const {
  std::optional<Stamp> next;
  for (const auto& stage : stages_) next = measurement::earlier(next, stage->deadline());
  return next;
}

void ReplayFaults::tick(Stamp now) {
  for (const auto& stage : stages_)
    if (const auto due = stage->deadline(); due && *due <= now) stage->tick(now);
}

std::vector<std::string> ReplayFaults::lines() const {
  std::vector<std::string> all;
  for (const auto& stage : stages_) {
    std::string text;
    const auto hits = stage->hits();
    for (const auto& word : rig_config::fault_vocabulary())
      if (hits[word.kind] > 0)
        text += fmt::format("{} {} {}", text.empty() ? "" : ",", word.name, hits[word.kind]);
    all.push_back(stage->device() + ": faults hit" + (text.empty() ? " nothing" : text));
  }
  return all;
}

}  // namespace drydock::replay
