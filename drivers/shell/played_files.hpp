#pragma once

#include <memory>
#include <span>
#include <vector>

#include "drivers/device/device.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/device_actor.hpp"
#include "drivers/shell/recording_clock.hpp"

namespace drydock::shell {

/// A recording (`file:` link) with the devices that read it: each byte and frame comes once, for
/// all of them.
struct PlayedFile {
  link::Uri uri;
  device::Travels travels = device::Travels::as_bytes;
  std::vector<std::size_t> devices;  ///< indices
  RecordingClock clock{};            ///< one for all of them
};

/// Those among the links of the devices, in the order of their first devices.
std::vector<PlayedFile> played_files(std::span<const std::unique_ptr<device::Device>> devices);

/// Plays the file to its drivers from `start`; its deadline() is empty at the end. Throws
/// std::runtime_error with one line if the file cannot be read.
std::unique_ptr<Actor> player_of(const PlayedFile& file, std::vector<DeviceActor*> drivers,
                                 Stamp start);

}  // namespace drydock::shell
