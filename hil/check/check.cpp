#include "hil/check/check.hpp"

#include <fmt/format.h>

#include "drivers/link/uri.hpp"

namespace drydock::check {

rig_config::LoadOptions load_options() {
  rig_config::LoadOptions options;
  options.link_check = [](std::string_view uri) -> std::optional<std::string> {
    const auto parsed = link::parse_uri(uri);
    if (parsed) return std::nullopt;
    return parsed.error().message;
  };
  return options;
}

int check(const std::vector<std::string>& files, std::FILE* out) {
  bool sound = true;
  for (const std::string& file : files) {
    const rig_config::Problems problems = rig_config::check_file(file, load_options());
    for (const rig_config::Problem& problem : problems) fmt::print(out, "{}\n", to_string(problem));
    if (problems.empty()) fmt::print(out, "{}: ok\n", file);
    sound = sound && problems.empty();
  }
  return sound ? 0 : 1;
}

}  // namespace drydock::check
