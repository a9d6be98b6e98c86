#include "hil/diff/side.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

#include "hil/replay/replay_rig.hpp"
#include "hil/replay/summarize.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::diff {

Side read_side(const std::string& file) {
  if (const auto why = rig_config::file_trouble(file); !why.empty())
    throw std::runtime_error(file + ": " + why);
  if (replay::is_recording(file)) {
    auto curves = replay::summarize(file);
    std::erase_if(curves.notes, [&](const std::string& note) {  // the table's head has the name
      return note.starts_with("replay of " + file);
    });
    auto json = nlohmann::ordered_json::parse(to_json(curves));
    return {file, std::move(json), std::move(curves)};
  }
  std::ifstream in(file, std::ios::binary);
  auto json = nlohmann::ordered_json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("devices") || !json.contains("duration_s"))
    throw std::runtime_error(
        fmt::format("{}: neither a recording (MCAP) nor the summary of a run (--json)", file));
  return {file, std::move(json), {}};
}

}  // namespace drydock::diff
