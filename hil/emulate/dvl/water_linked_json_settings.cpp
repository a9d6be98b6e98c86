#include "hil/emulate/dvl/water_linked_json_settings.hpp"

#include <fmt/format.h>

#include <numbers>

#include "hil/emulate/dvl/a50.hpp"
#include "hil/emulate/dvl/water_linked_json_document.hpp"

namespace drydock::emulate {
namespace {

std::string rfc_3339(measurement::Stamp at) {
  using namespace std::chrono;
  const sys_time<nanoseconds> time{at.time_since_epoch()};
  const auto day = floor<days>(time);
  const year_month_day date{day};
  const hh_mm_ss clock{floor<milliseconds>(time - day)};
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}.{:03}Z", static_cast<int>(date.year()),
                     static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                     clock.hours().count(), clock.minutes().count(), clock.seconds().count(),
                     clock.subseconds().count());
}

}  // namespace

WaterLinkedJsonSettings::WaterLinkedJsonSettings() {
  configuration_.mounting_rotation_rad = 0;
  configuration_.acoustic_enabled = configuration_.periodic_cycling = true;
  configuration_.dark_mode = false;
  configuration_.sound_speed_mps = 1475;
}

std::string_view WaterLinkedJsonSettings::set(std::string_view parameters) {
  const auto wanted = parameters_of(parameters);
  if (!wanted) return "Invalid parameters";
  const double sound = wanted->sound_speed_mps.value_or(a50::slowest_sound_mps);
  const double rotation = wanted->mounting_rotation_rad.value_or(0);
  const auto mode = range_mode_of(wanted->range_mode.empty() ? range_mode_ : wanted->range_mode);
  if (sound < a50::slowest_sound_mps || sound > a50::fastest_sound_mps || rotation < 0 ||
      rotation > 2 * std::numbers::pi || !mode)
    return "Value out of range";
  take(*wanted);
  mode_ = *mode;
  return {};
}

void WaterLinkedJsonSettings::take(const Configuration& wanted) {
  const auto set = [](auto& setting, const auto& value) {
    if (value) setting = value;
  };
  set(configuration_.sound_speed_mps, wanted.sound_speed_mps);
  set(configuration_.mounting_rotation_rad, wanted.mounting_rotation_rad);
  set(configuration_.acoustic_enabled, wanted.acoustic_enabled);
  set(configuration_.dark_mode, wanted.dark_mode);
  set(configuration_.periodic_cycling, wanted.periodic_cycling);
  sound_is_set_ = sound_is_set_ || wanted.sound_speed_mps;
  if (!wanted.range_mode.empty()) range_mode_ = wanted.range_mode;
}

WaterLinkedJsonSettings::Configuration WaterLinkedJsonSettings::configuration() const {
  Configuration told = configuration_;
  told.range_mode = range_mode_;
  return told;
}

std::optional<double> WaterLinkedJsonSettings::sound_speed_mps() const {
  return sound_is_set_ ? configuration_.sound_speed_mps : std::nullopt;
}

std::string water_linked_time_status(measurement::Stamp device_time) {
  return fmt::format(R"({{"system_time":"{}","ntp_synced":true,"ntp_synced_to":"pool.ntp.org",)"
                     R"("ntp_seconds_since_last_sync":0}})",
                     rfc_3339(device_time));
}

}  // namespace drydock::emulate
