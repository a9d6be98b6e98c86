#include "hil/info/info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "drivers/capture/foreign_content.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/probe/probe_report.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "drivers/text/printable.hpp"
#include "hil/info/capture_info.hpp"
#include "hil/info/line_info.hpp"
#include "hil/info/recording_info.hpp"
#include "hil/info/total_info.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::info {
namespace {

bool begins_as_mcap(const std::string& file) {
  std::array<char, mcap::magic.size()> head{};
  std::ifstream in(file, std::ios::binary);
  return in.read(head.data(), head.size()) &&
         std::memcmp(head.data(), mcap::magic.data(), head.size()) == 0;
}

struct FileInfo {
  int code = terminal::exit_failed;
  TotalInfo share{};
  std::string trouble{};  ///< why nothing was printed; empty: something was
};

FileInfo refuse_info(std::FILE* err, const std::string& why) {
  fmt::print(err, "info: {}\n", text::printable(why));
  return {terminal::exit_failed, {}, why};
}

FileInfo of_recording(const std::string& file, bool json, std::FILE* out, std::FILE* err) {
  auto recording = record::Recording::open(file);
  if (!recording) return refuse_info(err, recording.error().line);
  const auto found = info_of(*recording, file);
  fmt::print(out, "{}", json ? to_json(found) : to_text(found));
  FileInfo info{terminal::exit_of(found.damage.empty() && found.holds_something()), {}};
  for (const auto& [name, topic] : found.topics) info.share.messages += topic.messages;
  if (found.holds_something()) {
    info.share.first = found.begin.time_since_epoch();
    info.share.last = found.end.time_since_epoch();
  }
  return info;
}

TotalInfo share_of(const std::optional<CaptureInfo>& frames, const std::vector<LineInfo>& lines) {
  TotalInfo share;
  if (frames) share.add({0, 0, frames->frames, 0, frames->first, frames->last});
  for (const auto& line : lines) share.add({0, 0, 0, 0, line.first, line.last});
  return share;
}

/// What the drivers hear in a capture, and for a file of bytes all that can be said.
FileInfo of_capture(const std::string& file, bool json, std::FILE* out, std::FILE* err) {
  const auto lines = line_infos(file);
  const auto frames = capture_info(file);
  const bool on_bus = frames && (lines.empty() || frames->frames > 0);
  const bool sound =
      (!on_bus || (frames->frames > 0 && frames->damage.empty())) &&
      std::ranges::all_of(lines, [](const auto& line) { return line.damage.empty(); });
  if (json && (on_bus || !lines.empty())) {
    fmt::print(out, "{}", on_bus ? to_json(*frames, lines) : to_json(file, lines));
    return {terminal::exit_of(sound), share_of(frames, lines)};
  }
  if (!json && on_bus) fmt::print(out, "{}", to_text(*frames));
  if (!json && !lines.empty()) fmt::print(out, "{}", to_text(file, lines));
  const auto foreign = on_bus || !lines.empty()
                           ? std::string_view()
                           : capture::foreign_content(capture::FileBlocks(file).read());
  if (!foreign.empty()) return refuse_info(err, fmt::format("{}: {}", file, foreign));
  const auto heard = probe::find_sensors(link::file_uri(file) + "?speed=max", 0);
  if (!on_bus && lines.empty() && !json)
    fmt::print(out, "{}: {} bytes of a line{}\n", text::printable(file),
               std::filesystem::file_size(file), capture::has_times(file) ? "" : ", without times");
  json ? probe::print_json(heard, out) : probe::print_text(heard, out);
  const bool known = on_bus || !lines.empty() || heard.confidence() > survey::Confidence::nothing;
  return {terminal::exit_of(sound && known), share_of(frames, lines)};
}

FileInfo of_file(const std::string& file, bool json, std::FILE* out, std::FILE* err) {
  if (const auto why = rig_config::file_trouble(file); !why.empty())
    return refuse_info(err, file + ": " + why);
  const bool recording = begins_as_mcap(file) || file.ends_with(".mcap");
  auto info = recording ? of_recording(file, json, out, err) : of_capture(file, json, out, err);
  info.share.files = 1;
  std::error_code unknown;
  info.share.size = std::filesystem::file_size(file, unknown);
  return info;
}

}  // namespace

int info(const std::vector<std::string>& files, bool json, std::FILE* out, std::FILE* err) {
  if (files.size() == 1) return of_file(files.front(), json, out, err).code;
  int code = terminal::exit_success;
  TotalInfo total;
  if (json) fmt::print(out, "{{\"files\": [\n");
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (i > 0) fmt::print(out, "{}\n", json ? "," : "");
    const auto info = of_file(files[i], json, out, err);
    code = std::max(code, info.code);
    total.add(info.share);
    if (json && !info.trouble.empty()) {
      const nlohmann::json refused{{"file", files[i]}, {"trouble", info.trouble}};
      fmt::print(out, "{}\n", text::json_of_any_text(refused));
    }
  }
  if (json)
    fmt::print(out, "],\n\"total\": {}}}\n", to_json(total));
  else
    fmt::print(out, "\n{}", to_text(total));
  return code;
}

}  // namespace drydock::info
