#include "hil/emulate/can/nmea2000_settings.hpp"

namespace drydock::emulate {

// Device instance, system instance, then each description: encoding, length, bytes.

Nmea2000Settings settings_in(const Memory& memory) {
  Nmea2000Settings settings;
  const auto& bytes = memory.bytes;
  if (bytes.size() < 2) return settings;
  settings.device_instance = bytes[0];
  settings.system_instance = bytes[1];
  std::size_t at = 2;
  for (auto& text : settings.descriptions) {
    if (bytes.size() < at + 2 || bytes.size() < at + 2 + bytes[at + 1]) break;
    text.encoding = bytes[at];
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at + 2);
    text.bytes.assign(begin, begin + bytes[at + 1]);
    at += 2 + text.bytes.size();
  }
  return settings;
}

void keep(const Nmea2000Settings& settings, Memory& memory) {
  memory.bytes = {settings.device_instance, settings.system_instance};
  for (const auto& text : settings.descriptions) {
    memory.bytes.push_back(text.encoding);
    memory.bytes.push_back(static_cast<std::uint8_t>(text.bytes.size()));
    memory.bytes.insert(memory.bytes.end(), text.bytes.begin(), text.bytes.end());
  }
}

}  // namespace drydock::emulate
