#include "drivers/survey/rig_block.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace drydock::survey {
namespace {

/// A TOML basic string.
std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

}  // namespace

double nominal_rate_hz(double measured_hz) {
  constexpr double tolerance = 0.03;
  const double whole = std::round(measured_hz);
  if (whole >= 1 && std::abs(measured_hz - whole) <= tolerance * whole) return whole;
  const double step = std::pow(10, std::floor(std::log10(measured_hz)) - 2);
  return std::round(measured_hz / step) * step;
}

std::string rig_block(const FoundDevice& device) {
  std::string text = fmt::format("[[device]]\nname = {}\nkind = \"{}\"\nprotocol = {}\nlink = {}\n",
                                 quoted(device.name), to_string(device.kind),
                                 quoted(device.protocol), quoted(device.link));
  if (device.rate_hz && *device.rate_hz > 0)
    text += fmt::format("rate_hz = {:.6g}\n", nominal_rate_hz(*device.rate_hz));
  if (device.address != 0) text += fmt::format("address = {}\n", device.address);
  return text;
}

void name_devices(std::vector<FoundDevice>& devices) {
  std::array<unsigned, measurement::kinds.size()> taken{};
  for (auto& device : devices) {
    const unsigned number = ++taken[static_cast<std::size_t>(device.kind)];
    device.name = number == 1 ? std::string(to_string(device.kind))
                              : fmt::format("{}_{}", to_string(device.kind), number);
  }
}

}  // namespace drydock::survey
