#include "drivers/monitor/found_devices.hpp"

#include <algorithm>

#include "drivers/link/uri.hpp"

namespace drydock::monitor {

std::vector<std::unique_ptr<device::Device>> devices_of(const probe::ProbeReport& report) {
  std::vector<std::unique_ptr<device::Device>> devices;
  for (const auto& found : report.devices) {
    device::DeviceOptions options;
    options.name = found.name;
    options.link = found.link;
    options.driver.kind = found.kind;
    options.driver.protocol = found.protocol;
    options.driver.description = found.description;
    options.driver.address = found.address;
    options.driver.device = static_cast<std::uint16_t>(devices.size());
    const auto uri = link::parse_uri(found.link).value();
    options.driver.baud = uri.baud();
    options.driver.byte_frame = uri.byte_frame();
    options.driver.bitrate = uri.bitrate().value_or(options.driver.bitrate);
    if (uri.recorded()) {
      options.life_cycle.reopen_when_quiet = false;  // opening it again would restart the capture
      options.life_cycle.quiet_but_up = " in the recording";
    }
    options.nominal_rate_hz = found.rate_hz ? survey::nominal_rate_hz(*found.rate_hz) : 0;
    if (found.rate_hz && *found.rate_hz > 0)  // a sensor may be slower than most
      options.life_cycle.stale_after =
          std::max(options.life_cycle.stale_after, measurement::from_seconds(5 / *found.rate_hz));
    auto made = device::Device::make(std::move(options));
    if (made) devices.push_back(std::move(*made));
  }
  return devices;
}

}  // namespace drydock::monitor
