#include "drivers/survey/node_names.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace drydock::survey {
namespace {

template <class Number, std::size_t Size>
std::string_view find(const std::array<std::pair<Number, std::string_view>, Size>& names,
                      Number of) {
  for (const auto& [number, name] : names)
    if (number == of) return name;
  return {};
}

}  // namespace

std::string_view manufacturer(std::uint16_t code) {
  constexpr std::array<std::pair<std::uint16_t, std::string_view>, 15> names{{
      {135, "Airmar"},
      {137, "Maretron"},
      {140, "Lowrance"},
      {144, "Mercury Marine"},
      {229, "Garmin"},
      {273, "Actisense"},
      {275, "Navico"},
      {358, "Victron Energy"},
      {381, "B&G"},
      {437, "Digital Yacht"},
      {717, "Yacht Devices"},
      {1851, "Raymarine"},
      {1855, "Furuno"},
      {1857, "Simrad"},
      {1862, "Yamaha"},
  }};
  return find(names, code);
}

std::string_view device_class(std::uint8_t number) {
  constexpr std::array<std::pair<std::uint8_t, std::string_view>, 15> names{{
      {10, "system tools"},
      {20, "safety systems"},
      {25, "internetwork device"},
      {30, "electrical distribution"},
      {35, "electrical generation"},
      {40, "steering and control surfaces"},
      {50, "propulsion"},
      {60, "navigation"},
      {70, "communication"},
      {75, "sensor communication interface"},
      {80, "instrumentation"},
      {85, "external environment"},
      {90, "internal environment"},
      {120, "display"},
      {125, "entertainment"},
  }};
  return find(names, number);
}

/// CiA 301: the lower half of the device type is the number of the profile.
std::string canopen_profile(std::uint32_t device_type) {
  constexpr std::array<std::pair<std::uint16_t, std::string_view>, 7> names{{
      {401, "inputs and outputs"},
      {402, "drives"},
      {404, "measuring devices"},
      {406, "encoders"},
      {408, "hydraulic valves"},
      {410, "inclinometers"},
      {418, "batteries"},
  }};
  const auto number = static_cast<std::uint16_t>(device_type & 0xFFFFU);
  const auto name = find(names, number);
  return name.empty() ? std::string() : fmt::format("CiA {}, {}", number, name);
}

std::string in_words(const wire::j1939::Name& name) {
  const auto maker = manufacturer(name.manufacturer_code);
  const auto kind = device_class(name.vehicle_system);
  constexpr unsigned marine = 4;
  std::string text =
      maker.empty() ? fmt::format("manufacturer {}", name.manufacturer_code) : std::string(maker);
  if (name.industry_group == marine && !kind.empty()) text += fmt::format(", {}", kind);
  return text + fmt::format(", function {}, serial {}", name.function, name.identity_number);
}

}  // namespace drydock::survey
