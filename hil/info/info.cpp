#include "hil/info/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "drivers/capture/line_file.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/probe/probe_report.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/printable.hpp"
#include "hil/info/capture_info.hpp"
#include "hil/info/line_info.hpp"
#include "hil/info/recording_info.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::info {
namespace {

bool begins_as_mcap(const std::string& file) {
  std::array<char, mcap::magic.size()> head{};
  std::ifstream in(file, std::ios::binary);
  return in.read(head.data(), head.size()) &&
         std::memcmp(head.data(), mcap::magic.data(), head.size()) == 0;
}

int refuse_info(std::FILE* err, const std::string& why) {
  fmt::print(err, "info: {}\n", text::printable(why));
  return terminal::exit_failed;
}

int of_recording(const std::string& file, bool json, std::FILE* out, std::FILE* err) {
  auto recording = record::Recording::open(file);
  if (!recording) return refuse_info(err, recording.error().line);
  const auto found = info_of(*recording, file);
  fmt::print(out, "{}", json ? to_json(found) : to_text(found));
  return terminal::exit_of(found.damage.empty() && found.holds_something());
}

/// What the drivers hear in a capture, and for a file of bytes all that can be said.
int of_capture(const std::string& file, bool json, std::FILE* out) {
  const auto lines = line_infos(file);
  const auto frames = capture_info(file);
  const bool on_bus = frames && (lines.empty() || frames->frames > 0);
  const bool sound =
      (!on_bus || (frames->frames > 0 && frames->damage.empty())) &&
      std::ranges::all_of(lines, [](const auto& line) { return line.damage.empty(); });
  if (json && (on_bus || !lines.empty())) {
    fmt::print(out, "{}", on_bus ? to_json(*frames, lines) : to_json(file, lines));
    return terminal::exit_of(sound);
  }
  if (!json && on_bus) fmt::print(out, "{}", to_text(*frames));
  if (!json && !lines.empty()) fmt::print(out, "{}", to_text(file, lines));
  const auto heard = probe::find_sensors(link::file_uri(file) + "?speed=max", 0);
  if (!on_bus && lines.empty() && !json)
    fmt::print(out, "{}: {} bytes of a line{}\n", text::printable(file),
               std::filesystem::file_size(file), capture::has_times(file) ? "" : ", without times");
  json ? probe::print_json(heard, out) : probe::print_text(heard, out);
  return terminal::exit_of(
      sound && (on_bus || !lines.empty() || heard.confidence() > survey::Confidence::nothing));
}

}  // namespace

int info(const std::string& file, bool json, std::FILE* out, std::FILE* err) {
  if (const auto why = rig_config::file_trouble(file); !why.empty())
    return refuse_info(err, file + ": " + why);
  const bool recording = begins_as_mcap(file) || file.ends_with(".mcap");
  return recording ? of_recording(file, json, out, err) : of_capture(file, json, out);
}

}  // namespace drydock::info
