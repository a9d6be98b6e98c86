#include "drivers/shell/played_files.hpp"

#include <algorithm>
#include <utility>

#include "drivers/shell/recorded_bus.hpp"
#include "drivers/shell/recorded_line.hpp"

namespace drydock::shell {

std::vector<PlayedFile> played_files(std::span<const std::unique_ptr<device::Device>> devices) {
  std::vector<PlayedFile> files;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto uri = link::parse_uri(devices[i]->options().link);
    if (!uri || !uri->recorded()) continue;
    auto file = std::ranges::find_if(files, [&](const PlayedFile& known) {
      return known.uri.text == uri->text && known.travels == devices[i]->travels();
    });
    if (file == files.end())
      file = files.insert(files.end(), PlayedFile{*uri, devices[i]->travels(), {}});
    file->devices.push_back(i);
  }
  for (auto& file : files) {
    std::vector<device::DriverOptions> drivers;
    for (const std::size_t i : file.devices) drivers.push_back(devices[i]->options().driver);
    file.clock = clock_of(file.uri, drivers, file.travels);
  }
  return files;
}

std::unique_ptr<Actor> player_of(const PlayedFile& file, std::vector<DeviceActor*> drivers,
                                 Stamp start) {
  if (file.travels == device::Travels::as_frames)
    return std::make_unique<RecordedBus>(file.uri, std::move(drivers), start, file.clock);
  return std::make_unique<RecordedLine>(file.uri, std::move(drivers), start, file.clock);
}

}  // namespace drydock::shell
