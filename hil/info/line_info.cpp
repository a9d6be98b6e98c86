#include "hil/info/line_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers/capture/line_file.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "drivers/text/printable.hpp"
#include "hil/info/utc.hpp"

namespace drydock::info {
namespace {

std::string_view format_of(const std::string& file) {
  capture::FileBlocks blocks(file);
  const auto head = blocks.read();
  if (capture::Pcapng::recognises(head)) return "pcapng";
  return capture::PacketText::recognises(head) ? "packets as text" : "pcap";
}

double covered_s(const LineInfo& line) {
  return line.first && line.last ? std::chrono::duration<double>(*line.last - *line.first).count()
                                 : 0;
}

}  // namespace

std::vector<LineInfo> line_infos(const std::string& file) {
  if (!capture::has_packets(file)) return {};
  capture::LineFile all(file, false, "*");
  std::vector<LineInfo> infos;
  while (const auto read = all.next()) {
    infos.resize(std::max(infos.size(), read->line + 1));
    auto& info = infos[read->line];
    ++info.reads;
    info.bytes += read->bytes.size();
    if (!info.first) info.first = read->time;
    info.last = read->time;
  }
  const auto lines = all.lines();
  infos.resize(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    infos[i].name = lines[i].name;
    infos[i].serial = lines[i].serial;
    infos[i].damage = all.damage(lines[i].name);
    // The packet may have been one of any line.
    if (const auto cut = all.cut_note(); !cut.empty())
      infos[i].damage += (infos[i].damage.empty() ? "" : "; ") + cut;
  }
  return infos;
}

std::string to_text(const std::string& file, const std::vector<LineInfo>& lines) {
  const bool serial = std::ranges::all_of(lines, &LineInfo::serial);
  std::string text = fmt::format("{}: {}, {} {}\n", file, format_of(file), lines.size(),
                                 serial ? "serial lines" : "lines");
  for (const auto& line : lines)
    text += fmt::format("line {}: {} reads, {} bytes, {:.1f} s{}{}\n", line.name, line.reads,
                        line.bytes, covered_s(line), line.first ? utc::from(*line.first) : "",
                        line.damage.empty() ? "" : "; " + line.damage);
  return text::printable_lines(text);
}

nlohmann::json json_of(const std::vector<LineInfo>& lines) {
  auto list = nlohmann::json::array();
  for (const auto& line : lines)
    list.push_back({{"name", line.name},
                    {"reads", line.reads},
                    {"bytes", line.bytes},
                    {"begin", line.first ? utc::text(*line.first) : ""},
                    {"duration_s", covered_s(line)},
                    {"damage", line.damage}});
  return list;
}

std::string to_json(const std::string& file, const std::vector<LineInfo>& lines) {
  const nlohmann::json json{{"file", file}, {"format", format_of(file)}, {"lines", json_of(lines)}};
  return text::json_of_any_text(json) + "\n";
}

}  // namespace drydock::info
