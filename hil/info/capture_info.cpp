#include "hil/info/capture_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "drivers/capture/capture_file.hpp"
#include "drivers/terminal/data_size.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "drivers/text/printable.hpp"
#include "hil/info/utc.hpp"

namespace drydock::info {
namespace {

void add(const capture::Record& record, CaptureInfo& info) {
  ++info.frames;
  ++info.interfaces[std::string(record.interface)];
  ++info.identifiers[record.frame.id];
  if (!record.time) return;
  if (!info.first) info.first = info.last = record.time;
  const auto since_latest = *record.time - *info.last;
  if (since_latest < since_latest.zero()) return;
  info.longest = std::max(info.longest, since_latest);
  info.last = record.time;
}

}  // namespace

double CaptureInfo::duration_s() const {
  return first ? std::chrono::duration<double>(*last - *first).count() : 0;
}

std::optional<CaptureInfo> capture_info(const std::string& file) {
  capture::CaptureFile capture(file, "", "");
  CaptureInfo info;
  info.file = file;
  while (const auto record = capture.next()) add(*record, info);
  if (!capture.trouble().empty() || capture.frames().format() == nullptr) return {};
  info.format = capture.frames().format()->name;
  info.note = capture.frames().note();
  info.behind = capture.times().behind();
  info.most_behind = capture.times().most_behind();
  info.damage = capture::damage_text(capture.frames().tally());
  std::error_code unknown;
  info.size = std::filesystem::file_size(file, unknown);
  return info;
}

std::string to_text(const CaptureInfo& info) {
  std::string text =
      fmt::format("{}: CAN capture, {}, {}, {} frames, {} identifiers", info.file, info.format,
                  terminal::data_size_text(info.size), info.frames, info.identifiers.size());
  if (info.duration_s() > 0)
    text += fmt::format(", {:.1f} s, {:.1f} frames a second, longest gap {:.3f} s",
                        info.duration_s(), static_cast<double>(info.frames) / info.duration_s(),
                        std::chrono::duration<double>(info.longest).count());
  if (info.first) text += utc::from(*info.first);
  text += '\n';
  if (info.behind > 0)
    text += fmt::format(
        "the clock went back: {} frames have times before an earlier frame's, by up to {:.3f} s\n",
        info.behind, std::chrono::duration<double>(info.most_behind).count());
  if (!info.note.empty()) text += info.note + "\n";
  for (const auto& [name, frames] : info.interfaces)
    text +=
        fmt::format("interface {}: {} frames\n", name.empty() ? "without a name" : name, frames);
  if (!info.damage.empty()) text += info.damage + "\n";
  return text::printable_lines(text);
}

std::string to_json(const CaptureInfo& info, const std::vector<LineInfo>& lines) {
  nlohmann::json all = {{"file", info.file},
                        {"format", info.format},
                        {"size", info.size},
                        {"frames", info.frames},
                        {"duration_s", info.duration_s()},
                        {"begin", info.first ? utc::text(*info.first) : ""},
                        {"longest_gap_s", std::chrono::duration<double>(info.longest).count()},
                        {"frames_behind", info.behind},
                        {"most_behind_s", std::chrono::duration<double>(info.most_behind).count()},
                        {"interfaces", info.interfaces},
                        {"identifiers", info.identifiers.size()},
                        {"times", info.note},
                        {"damage", info.damage}};
  if (!lines.empty()) all["lines"] = json_of(lines);
  return text::json_of_any_text(all) + "\n";
}

}  // namespace drydock::info
