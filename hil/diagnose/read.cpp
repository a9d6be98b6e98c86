#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <span>
#include <stdexcept>

#include "drivers/diagnosis/monitors/device_monitor.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/monitor/found_devices.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/played_files.hpp"
#include "hil/diagnose/examination.hpp"
#include "hil/diagnose/sources.hpp"
#include "hil/replay/replay_bench.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"

namespace drydock::diagnose {
namespace {

using measurement::Stamp;

constexpr int looks_a_pause = 240;  ///< a trace may stand still for years
constexpr unsigned usual_baud = 9600;
/// A pause of all devices of a capture, in seconds and in messages that were due.
constexpr double shortest_hole_s = 3, fewest_missing = 10;
constexpr double usual_length_s = 600;  ///< spaces the curves of a file whose length is not known

std::uint64_t skipped_by(const shell::DeviceActor& actor) {
  return actor.device().on_bus() ? 0 : actor.device().vitals().stream.bytes_skipped;
}

std::string rest_note(const std::string& device, std::uint64_t bytes) {
  return fmt::format(
      "{}: the capture ends inside a message: its last bytes, {} of them, are no fault", device,
      bytes);
}

/// The devices of a capture in virtual time. Members are in the order in which they need each
/// other.
class CaptureBench final : public device::Listener, public device::Transmitter {
 public:
  CaptureBench(const rig_config::Rig& rig, std::vector<std::unique_ptr<device::Device>> devices,
               std::span<const shell::PlayedFile> files, Stamp start)
      : clock_(start), examination_(rig, start, usual_length_s) {
    for (const auto& device : rig.devices) rate_hz_ += device.rate_hz;
    for (auto& device : devices) add(std::move(device), start);
    for (const auto& file : files) play(file, start);
    std::vector<const device::Device*> all;
    for (const auto& actor : actors_) all.push_back(&actor->device());
    examination_.follow(followers_, std::move(all));
  }

  Outcome play(const std::string& source, bool has_times) {
    clock_.run_until(clock_.now());
    examination_.look(clock_.now());
    std::vector<std::uint64_t> skipped(actors_.size());
    while (const auto due = next()) {
      for (std::size_t i = 0; i < actors_.size(); ++i) skipped[i] = skipped_by(*actors_[i]);
      if (!is_hole(*due)) examination_.await(*due);
      clock_.run_until(*due);
      examination_.look(clock_.now());
    }
    auto outcome = examination_.result(source, clock_.now(), false, has_times, false);
    for (std::size_t i = 0; i < actors_.size(); ++i)
      if (const auto rest = skipped_by(*actors_[i]) - skipped[i]; rest > 0)
        outcome.notes.push_back(rest_note(actors_[i]->device().name(), rest));
    return outcome;
  }

 private:
  void add(std::unique_ptr<device::Device> device, Stamp start) {
    actors_.push_back(std::make_unique<shell::DeviceActor>(std::move(device), *this, *this, start,
                                                           measurement::Provenance::replayed));
    clock_.add(*actors_.back());
  }

  void play(const shell::PlayedFile& file, Stamp start) {
    std::vector<shell::DeviceActor*> readers;
    for (const std::size_t i : file.devices) readers.push_back(actors_[i].get());
    readers.front()->tap(followers_);
    files_.push_back(shell::player_of(file, std::move(readers), start));
    clock_.add(*files_.back());
  }

  std::optional<Stamp> next_message() const {
    std::optional<Stamp> first;
    for (const auto& file : files_)
      if (const auto due = file->deadline()) first = std::min(first.value_or(*due), *due);
    return first;
  }

  /// Several devices do not fall silent together: nobody listened.
  bool is_hole(Stamp due) const {
    const double pause_s = measurement::seconds(due - clock_.now());
    return actors_.size() > 1 && pause_s > shortest_hole_s && pause_s * rate_hz_ > fewest_missing;
  }

  /// The end of the next step: a look, or now while a file without times has more. Empty: all files
  /// are at their end.
  std::optional<Stamp> next() const {
    const auto first = next_message();
    if (!first) return {};
    const Stamp now = clock_.now();
    if (*first <= now) return now;
    if (is_hole(*first)) return first;
    return now + std::max<Stamp::duration>(diagnosis::look_period, (*first - now) / looks_a_pause);
  }

  void on_measurement(const measurement::Measurement& m) override { followers_.on_measurement(m); }
  void on_state(const device::Device&, const device::Transition&) override {}
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}

  shell::Lockstep clock_;
  double rate_hz_ = 0;  ///< of all devices
  host::Followers followers_;
  std::vector<std::unique_ptr<shell::DeviceActor>> actors_;
  std::vector<std::unique_ptr<shell::Actor>> files_;
  Examination examination_;
};

/// True if the sensor measures along axes of its own.
bool has_axes(const rig_config::DeviceConfig& device) {
  using rig_config::DeviceKind;
  return device.kind == DeviceKind::imu || device.kind == DeviceKind::dvl ||
         device.kind == DeviceKind::emlog;
}

/// The rate of a device is what it gave in the capture itself.
void leave_out_rates(Outcome& outcome) {
  const auto cause = diagnosis::Cause::wrong_rate;
  std::erase_if(outcome.findings, [&](const diagnosis::FindingAccount& finding) {
    return finding.cause == diagnosis::facts_of(cause).name;
  });
  Unseen& unseen = outcome.unseen.emplace_back(Unseen{{}, {cause}, "no rig file states a rate"});
  for (const auto& device : outcome.devices) unseen.devices.push_back(device.name);
}

shell::Pace pace_of(const shell::PlayedFile& file) { return file.clock.pace; }

}  // namespace

Outcome read_capture(const std::string& path, unsigned baud) {
  const unsigned rate = baud > 0 ? baud : usual_baud;
  const std::string uri = fmt::format("file:{}?speed=max&baud={}", path, rate);
  const auto report = probe::find_sensors(uri, 0);
  auto devices = monitor::devices_of(report);
  if (devices.empty()) {
    Outcome nothing;
    nothing.source = path;
    nothing.notes = probe::all_notes(report);
    return nothing;
  }
  const auto rig = host::rig_of(devices, path);
  const auto files = shell::played_files(devices);
  const auto timed = std::ranges::find(files, shell::Pace::arrival, pace_of);
  const bool has_times = timed != files.end() || devices.front()->on_bus();
  const Stamp start = timed != files.end()        ? timed->clock.first
                      : devices.front()->on_bus() ? files.front().clock.first
                                                  : Stamp{};  // bytes begin at zero
  auto outcome = CaptureBench(rig, std::move(devices), files, start).play(path, has_times);
  outcome.notes.insert(outcome.notes.end(), report.recording.begin(), report.recording.end());
  for (const auto& device : outcome.devices)
    if (device.refused > 0)
      outcome.notes.push_back(fmt::format("{}: its driver left out {} value{}; it says: {}",
                                          device.name, device.refused,
                                          device.refused == 1 ? "" : "s", device.last_error));
  if (has_times) leave_out_rates(outcome);
  if (std::ranges::count_if(rig.devices, has_axes) > 1)
    outcome.notes.emplace_back(
        "a capture tells no mountings: what one sensor says against another holds where their axes "
        "are the vehicle's; a rig file with mounting_deg says more");
  if (!has_times)
    outcome.notes.push_back(fmt::format(
        "a capture of bytes has no times{}",
        pace_of(files.front()) == shell::Pace::device
            ? " of arrival: those here are of the device's own clock"
            : fmt::format(": they count its bytes at {} baud, without the pauses", rate)));
  return outcome;
}

Outcome read_recording(const std::string& path) {
  auto recording = record::Recording::open(path);
  if (!recording) throw std::runtime_error(recording.error().line);
  const replay::RecordedRig rig(*recording);
  boost::asio::io_context io{1};
  replay::Pace pace(io, 0);
  const record::Selection all;
  replay::ReplayBench bench(*recording, rig.rig(), all, {});
  Examination examination(rig.rig(), bench.start(), usual_length_s);
  examination.follow(bench.followers(), bench.devices());
  bench.play(pace, [](double) { return true; });
  auto outcome = examination.result(path, bench.start() + bench.played(), false);
  if (!rig.trouble().empty()) outcome.notes.push_back(rig.trouble());
  if (auto note = recording->clock_note(); !note.empty()) outcome.notes.push_back(std::move(note));
  return outcome;
}

}  // namespace drydock::diagnose
