#include "hil/replay/rigs/captured_recording.hpp"

#include <algorithm>
#include <stdexcept>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/shell/lockstep.hpp"
#include "drivers/shell/played_files.hpp"
#include "drivers/shell/recorded_bus.hpp"
#include "drivers/shell/recorded_line.hpp"
#include "drivers/shell/recorded_starts.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "drivers/terminal/interrupt_flag.hpp"
#include "hil/replay/rigs/temporary_file.hpp"

namespace drydock::replay {
namespace {

using measurement::Stamp;

/// The recording has what came. What its drivers make of that, the replay finds out.
class Nobody final : public device::Listener, public device::Transmitter {
 public:
  void on_measurement(const measurement::Measurement&) override {}
  void on_state(const device::Device&, const device::Transition&) override {}
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
};

Stamp start_of(const std::vector<shell::PlayedFile>& files) {
  std::optional<Stamp> arrival, any;
  for (const auto& file : files) {
    if (file.clock.pace == shell::Pace::line) continue;
    auto& first = file.clock.pace == shell::Pace::arrival ? arrival : any;
    first = std::min(first.value_or(file.clock.first), file.clock.first);
  }
  return arrival.value_or(any.value_or(Stamp{}));
}

/// Plays the files of a rig to the recorder.
class Dubbing {
 public:
  Dubbing(const rig_config::Rig& rig, const std::string& path) : devices_(devices_of(rig)) {
    files_ = shell::played_files(devices_);
    const Stamp start = start_of(files_);
    clock_.emplace(start);
    recorder_.emplace(rig, host::RecordOptions{.path = path, .overwrite = true}, start,
                      record::WhenBehind::wait);
    for (auto& device : devices_) {
      actors_.push_back(std::make_unique<shell::DeviceActor>(
          std::move(device), nobody_, nobody_, start, measurement::Provenance::replayed));
      clock_->add(*actors_.back());
    }
    const auto starts = shell::recorded_starts(files_, start);
    for (std::size_t i = 0; i < files_.size(); ++i) play(files_[i], starts[i]);
  }

  /// False after Ctrl-C.
  bool run() {
    const terminal::InterruptFlag interrupt;
    while (const auto due = next()) {
      if (interrupt.set()) return false;
      clock_->run_until(std::max(*due, clock_->now()));
      for (std::size_t i = 0; i < files_.size(); ++i)
        if (!players_[i]->deadline() && !ends_.contains(files_[i].uri.text))
          ends_.emplace(files_[i].uri.text, clock_->now());
      recorder_->tick(clock_->now());
    }
    const auto end = recorder_->finish();
    if (recorder_->failed()) throw std::runtime_error(end);
    return true;
  }

  bool of_arrival() const {
    return std::ranges::any_of(
        files_, [](const auto& file) { return file.clock.pace == shell::Pace::arrival; });
  }
  /// By link, after run().
  const std::map<std::string, Stamp>& ends() const { return ends_; }

  std::vector<std::string> notes() const {
    std::vector<std::string> notes;
    const auto add = [&](std::string note) {
      if (!note.empty() && std::ranges::find(notes, note) == notes.end())
        notes.push_back(std::move(note));
    };
    for (const auto& file : files_) add(file.clock.in_words());
    for (const auto& line : lines_)
      for (auto& note : line->notes()) add(std::move(note));
    for (const auto& bus : buses_) {
      for (auto& note : bus->notes()) add(std::move(note));
      add(capture::damage_text(bus->frames().tally()));
    }
    return notes;
  }

 private:
  static std::vector<std::unique_ptr<device::Device>> devices_of(const rig_config::Rig& rig) {
    auto devices = shell::make_devices(rig);
    if (!devices) throw std::runtime_error(devices.error().message);
    return std::move(*devices);
  }

  void play(const shell::PlayedFile& file, Stamp start) {
    std::vector<shell::DeviceActor*> readers;
    for (const std::size_t i : file.devices) readers.push_back(actors_[i].get());
    readers.front()->tap(*recorder_);
    if (file.travels == device::Travels::as_frames)
      add(*buses_.emplace_back(
          std::make_unique<shell::RecordedBus>(file.uri, std::move(readers), start, file.clock)));
    else
      add(*lines_.emplace_back(
          std::make_unique<shell::RecordedLine>(file.uri, std::move(readers), start, file.clock)));
  }
  void add(shell::Actor& player) {
    players_.push_back(&player);
    clock_->add(player);
  }

  std::optional<Stamp> next() const {
    std::optional<Stamp> first;
    for (const auto* player : players_)
      if (const auto due = player->deadline()) first = std::min(first.value_or(*due), *due);
    return first;
  }

  Nobody nobody_;
  std::vector<std::unique_ptr<device::Device>> devices_;
  std::vector<shell::PlayedFile> files_;
  std::optional<shell::Lockstep> clock_;
  std::optional<host::RigRecorder> recorder_;
  std::vector<std::unique_ptr<shell::DeviceActor>> actors_;
  std::vector<std::unique_ptr<shell::RecordedBus>> buses_;
  std::vector<std::unique_ptr<shell::RecordedLine>> lines_;
  std::vector<shell::Actor*> players_;  ///< all of these, by file
  std::map<std::string, Stamp> ends_;
};

}  // namespace

CapturedRecording record_capture(const rig_config::Rig& rig) {
  const TemporaryFile file;
  Dubbing dubbing(rig, file.path());
  if (!dubbing.run()) throw std::runtime_error("ended early, before the capture was read");
  auto recording = record::Recording::open(file.path());
  if (!recording) throw std::runtime_error(recording.error().line);
  return {std::move(*recording), dubbing.notes(), dubbing.ends(), dubbing.of_arrival()};
}

}  // namespace drydock::replay
