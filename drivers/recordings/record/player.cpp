#include "drivers/recordings/record/player.hpp"

#include <algorithm>

#include "drivers/shell/rig_devices.hpp"
#include "rig_config/load.hpp"

namespace drydock::record {

namespace {

constexpr const char* rig_file = "rig.toml";
/// No driver waits this long for the rest of an epoch.
constexpr std::chrono::seconds last_wait{1};

/// A recording has no link to open again.
void stay_open(device::DeviceOptions& options) {
  options.life_cycle.reopen_when_quiet = false;
  options.life_cycle.quiet_but_up = " in the recording";
}

/// Discards the data that a driver sends, but reports them and their link to `sent`.
class Silenced final : public device::Transmitter {
 public:
  Silenced(const shell::Lockstep& clock, std::string link, shell::RawListener* sent)
      : clock_(clock), link_(std::move(link)), sent_(sent) {}
  void send(wire::Bytes bytes) override {
    if (sent_ != nullptr) sent_->on_bytes(link_, Direction::sent, bytes, clock_.now());
  }
  void send(const wire::CanFrame& frame) override {
    if (sent_ != nullptr) sent_->on_frame(link_, Direction::sent, frame, clock_.now());
  }

 private:
  const shell::Lockstep& clock_;
  std::string link_;
  shell::RawListener* sent_;
};

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

boost::system::result<rig_config::Rig, RecordingError> rig_of(const Recording& recording) {
  const std::string text = recording.attachment(rig_file);
  if (text.empty()) return RecordingError{"the recording has no rig.toml: which driver is unknown"};
  rig_config::LoadOptions options;
  options.devices_only = true;
  auto rig = rig_config::load_rig_text(text, rig_file, options);
  if (!rig) return RecordingError{"the recording's " + to_string(rig.error().front())};
  return std::move(*rig);
}

boost::system::result<std::unique_ptr<Player>, RecordingError> Player::make(
    const Recording& recording, const rig_config::Rig& rig, const Selection& selection,
    device::Listener& listener, shell::RawListener* sent) {
  const Stamp start =
      recording.begin().value_or(Stamp{}) + selection.from.value_or(Stamp::duration{0});
  std::unique_ptr<Player> player(new Player(start));
  player->on_link_.resize(recording.links().size());
  for (std::size_t i = 0; i < rig.devices.size(); ++i) {
    const std::string& name = rig.devices[i].name;
    const auto link = std::ranges::find_if(
        recording.links(), [&](const RecordedLink& l) { return has(l.devices, name); });
    if (link == recording.links().end()) continue;
    if (!selection.only.empty() && !has(selection.only, name) && !has(selection.only, link->name))
      continue;
    auto options = shell::device_options(rig, i);
    if (!options) return RecordingError{"the recording's " + options.error().message};
    stay_open(*options);
    auto device = device::Device::make(std::move(*options));
    if (!device) return RecordingError{"the recording's " + device.error().message};
    if ((*device)->on_bus() != link->frames)
      return RecordingError{"the recording's link of " + name + " is none for its protocol"};
    player->transmitters_.push_back(std::make_unique<Silenced>(player->clock_, link->uri, sent));
    player->devices_.push_back(std::make_unique<shell::DeviceActor>(
        std::move(*device), listener, *player->transmitters_.back(), start,
        measurement::Provenance::replayed));
    player->clock_.add(*player->devices_.back());
    player->on_link_[static_cast<std::size_t>(link - recording.links().begin())].push_back(
        player->devices_.back().get());
  }
  player->clock_.run_until(start);
  return player;
}

void Player::run_until(Stamp at) {
  if (at - clock_.now() > longest_pause) {
    clock_.run_until(clock_.now() + longest_pause);
    clock_.skip_to(at);
  }
  clock_.run_until(std::max(at, clock_.now()));
}

void Player::play(const RawEvent& event) {
  run_until(event.at());
  if (event.direction() != Direction::received) return;
  for (shell::DeviceActor* device : on_link_[event.link]) {
    if (const auto* read = std::get_if<RawBytes>(&event.content))
      device->receive(read->data, read->at);
    else
      device->receive(std::get<RawFrame>(event.content).frame, event.at());
  }
}

void Player::set_port(std::size_t link, bool there) {
  for (shell::DeviceActor* device : on_link_[link]) device->set_port(there, clock_.now());
}

void Player::end_of_recording(std::size_t link) {
  for (shell::DeviceActor* device : on_link_[link]) device->end_of_recording(clock_.now());
}

void Player::finish(Stamp end) {
  run_until(end);
  for (const auto& device : devices_) device->stop(clock_.now());
}

void play(Recording& recording, const Selection& selection, Player& player,
          const std::function<void(const RawEvent&)>& on_event) {
  const Stamp begin = recording.begin().value_or(Stamp{});
  while (const auto event = recording.next()) {
    const auto* raw = std::get_if<RawEvent>(&*event);
    if (raw == nullptr || !selection.takes(recording.links()[raw->link]) ||
        !selection.holds(raw->at(), begin))
      continue;
    if (on_event) on_event(*raw);
    player.play(*raw);
  }
  player.finish(player.now() + last_wait);
}

boost::system::result<void, RecordingError> play(const std::string& path,
                                                 const Selection& selection,
                                                 device::Listener& listener) {
  auto recording = Recording::open(path);
  if (!recording) return recording.error();
  const auto rig = rig_of(*recording);
  if (!rig) return RecordingError{path + ": " + rig.error().line};
  auto player = Player::make(*recording, *rig, selection, listener);
  if (!player) return RecordingError{path + ": " + player.error().line};
  play(*recording, selection, **player);
  return {};
}

}  // namespace drydock::record
