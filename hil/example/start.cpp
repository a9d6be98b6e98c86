#include "hil/example/start.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <optional>

#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/unkept_path.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::example {
namespace {

/// A start, and the words in it that the new file has otherwise.
struct Start {
  std::string_view kind, file, placeholder, next;
};

constexpr std::array all_starts{
    Start{"rig", "starts/rig.toml", "NAME", "drydock run {} --for 30s --speed max"},
    Start{"mission", "starts/mission.toml", "NAME", "mission = \"{}\" in the [rig] of a rig file"},
    Start{"waypoints", "starts/waypoints.toml", "NAME",
          "mission = \"{}\" in the [rig] of a rig file"},
    Start{"sensor", "starts/sensor.toml", "NAME", "emulate = {{ errors = \"{}\" }} of a device"},
    Start{"vehicle", "vehicles/nps-auv-ii.toml", "nps-auv-ii",
          "drydock maneuver {} turning-circle"}};

std::string replaced(std::string text, std::string_view what, const std::string& with) {
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, at + with.size()))
    text.replace(at, what.size(), with);
  return text;
}

/// The text of the new file. Empty: the start did not come with this program.
std::optional<std::string> text_of(const Start& start, const std::string& name) {
  const auto folder = rig_config::shipped_folder() / "rig_config";
  std::ifstream in(folder / start.file, std::ios::binary);
  if (!in) return {};
  std::string text{std::istreambuf_iterator<char>(in), {}};
  text = replaced(std::move(text), fmt::format("\"{}\"", start.placeholder), "\"" + name + "\"");
  return replaced(std::move(text), "../schema/", (folder / "schema/").string());
}

int refuse_start(std::FILE* err, const std::string& why, int code) {
  fmt::print(err, "new: {}\n", why);
  return code;
}

const Start& start_of(const std::string& kind) {
  for (const auto& one : all_starts)
    if (one.kind == kind) return one;
  return all_starts.front();
}

}  // namespace

int start(const StartOptions& options, std::FILE* out, std::FILE* err) {
  const Start& from = start_of(options.kind);
  const std::string file = options.name + ".toml";
  const auto text = text_of(from, options.name);
  if (!text)
    return refuse_start(err, "the files that come with the program are not beside it",
                        terminal::exit_failed);
  if (!options.overwrite && std::filesystem::exists(file))
    return refuse_start(err, file + ": File exists; --overwrite replaces it",
                        terminal::exit_failed);
  terminal::UnkeptPath made(file);
  std::ofstream to(file, std::ios::binary);
  to << *text;
  to.close();
  if (!to)
    return refuse_start(err, file + ": cannot be written: " + std::strerror(errno),
                        terminal::exit_failed);
  made.keep();
  fmt::print(out, "{}: change it, then drydock check {}\n", file, file);
  fmt::print(out, "use it: {}\n", fmt::format(fmt::runtime(from.next), file));
  return terminal::exit_success;
}

}  // namespace drydock::example
