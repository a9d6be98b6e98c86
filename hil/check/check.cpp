#include "hil/check/check.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "drivers/link/uri.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/printable.hpp"
#include "estimators/hydrodynamics/model.hpp"
#include "estimators/vehicle/vehicle.hpp"
#include "hil/check/check_dbc.hpp"
#include "hil/check/check_rig.hpp"
#include "hil/check/line_load.hpp"

namespace drydock::check {

namespace {

using rig_config::Problems;

Problems check_vehicle(const rig_config::VehicleConfig& config, const std::string& file) try {
  hydrodynamics::Model{vehicle::dimensional(config)};
  return {};
} catch (const std::invalid_argument& error) {
  return {{file, 1, 1, "/vehicle", error.what()}};
}

/// First the problems of the file as such, then those of what it describes.
Problems problems_of(const std::string& file, const CheckOther& other) {
  if (other)
    if (auto problems = other(file)) return std::move(*problems);
  Problems problems = rig_config::check_file(file, load_options());
  if (!problems.empty()) return problems;
  if (const auto rig = rig_config::load_rig(file, load_options())) return check_rig(*rig);
  if (const auto mission = rig_config::load_mission(file)) return check_mission(*mission);
  if (const auto vehicle = rig_config::load_vehicle(file)) return check_vehicle(*vehicle, file);
  return {};
}

/// What is lost in a sound rig that starts.
Problems warnings_of(const std::string& file) {
  const auto rig = rig_config::load_rig(file, load_options());
  return rig ? overloaded_lines(*rig) : Problems{};
}

}  // namespace

rig_config::LoadOptions load_options() {
  rig_config::LoadOptions options;
  options.link_check = [](std::string_view uri) -> std::optional<std::string> {
    const auto parsed = link::parse_uri(uri);
    if (parsed) return std::nullopt;
    return parsed.error().message;
  };
  return options;
}

rig_config::Loaded<rig_config::Rig> load_sound_rig(const std::string& path, Use use) {
  auto rig = rig_config::load_rig(path, load_options());
  if (!rig) return rig;
  if (auto problems = check_rig(*rig, use); !problems.empty()) return problems;
  return rig;
}

int check(const std::vector<std::string>& files, std::FILE* out, const CheckOther& other) {
  bool sound = true;
  for (const std::string& file : files) {
    if (is_dbc(file)) {
      sound = check_dbc(file, out) && sound;
      continue;
    }
    const Problems problems = problems_of(file, other);
    for (const auto& problem : problems)
      fmt::print(out, "{}\n", text::printable(to_string(problem)));
    if (problems.empty()) {
      for (const auto& warning : warnings_of(file))
        fmt::print(out, "{}\n", text::printable(to_string(warning)));
      fmt::print(out, "{}: ok\n", text::printable(file));
    }
    sound = sound && problems.empty();
  }
  return sound ? terminal::exit_success : terminal::exit_usage;
}

}  // namespace drydock::check
