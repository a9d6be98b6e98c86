#include "drivers/capture/line_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "drivers/wire/packed_content.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::capture {
namespace {

bool is_regular(const std::string& file) {
  std::error_code none;
  return std::filesystem::is_regular_file(file, none);
}

/// Those that said something, or all where none did: `10.0.0.7:16171, 10.0.0.2:50312`.
std::string names_of(const std::vector<PacketLines::Line>& lines) {
  constexpr std::size_t most = 16;
  std::vector<std::string_view> names;
  const bool any = std::ranges::any_of(lines, [](const auto& line) { return line.bytes > 0; });
  for (const auto& line : lines)
    if (!any || line.bytes > 0) names.emplace_back(line.name);
  const std::size_t left = names.size() - std::min(names.size(), most);
  names.resize(names.size() - left);
  return fmt::format("{}{}", fmt::join(names, ", "),
                     left > 0 ? fmt::format(" and {} more (drydock info)", left) : "");
}

}  // namespace

LineFile::LineFile(const std::string& file, bool raw, std::string interface)
    : file_(file), interface_(std::move(interface)), raw_(raw), blocks_(file), content_(raw) {}

bool LineFile::begin() {
  begun_ = true;
  first_ = blocks_.read();
  if (!raw_) packed_ = wire::packed_content(wire::as_text(first_));
  if (raw_ || !PacketLines::recognises(first_)) return false;
  packets_.emplace(first_);
  buffer_.assign(first_.begin(), first_.end());
  if (interface_.empty() && is_regular(file_)) choose();
  return true;
}

/// Looks at the whole file: if one line alone says something, it is that one.
void LineFile::choose() {
  LineFile whole(file_, false, "*");
  whole.end_when(ended_);
  while (whole.next()) continue;
  const auto lines = whole.lines();
  const auto speaks = [](const auto& line) { return line.bytes > 0; };
  if (std::ranges::count_if(lines, speaks) == 1)
    interface_ = std::ranges::find_if(lines, speaks)->name;
}

std::optional<LineFile::Read> LineFile::next() {
  const bool at_start = !begun_;
  if (at_start) begin();
  if (!packed_.empty()) return {};
  if (packets_) return next_packet();
  for (bool at_first = at_start;; at_first = false) {
    if (const auto part = next_part()) return part;
    const Bytes block = at_first ? first_ : blocks_.read();
    block_ = block.empty() ? content_.finish() : content_.of(block);
    part_ = part_from_ = 0;
    if (block.empty() && block_.empty()) return {};
  }
}

/// Each line that has a time; then what is behind the last one, or a block without times as a
/// whole.
std::optional<LineFile::Read> LineFile::next_part() {
  if (part_from_ == block_.size()) return {};
  const auto times = content_.times();
  const bool timed = part_ < times.size();
  if (timed) last_time_ = times[part_].time;
  const std::size_t through = timed ? times[part_++].through : block_.size();
  const Bytes bytes = block_.first(through).subspan(part_from_);
  part_from_ = through;
  return Read{last_time_, bytes};
}

/// Of several lines the one that was asked for; without a choice none, which trouble() tells.
std::optional<LineFile::Read> LineFile::next_packet() {
  while (const auto piece = next_piece())
    if (interface_ == "*" || packets_->lines()[piece->line].name == interface_)
      return Read{piece->time, piece->bytes, piece->line};
  return {};
}

std::optional<PacketLines::Piece> LineFile::next_piece() {
  for (;;) {
    const Bytes rest = Bytes{buffer_}.subspan(at_);
    const Scan scan = packets_->scan(rest);
    if (scan.kind == Scan::Kind::need_more) {
      buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
      at_ = 0;
      const Bytes block = blocks_.read();
      if (block.empty()) return packets_->finish();
      buffer_.insert(buffer_.end(), block.begin(), block.end());
      continue;
    }
    at_ += scan.size;
    if (scan.kind != Scan::Kind::frame) continue;
    if (const auto piece = packets_->read(rest.first(scan.size))) return piece;
  }
}

std::vector<PacketLines::Line> LineFile::lines() const {
  return packets_ ? packets_->lines() : std::vector<PacketLines::Line>{};
}

std::string LineFile::trouble() const {
  if (blocks_.error() != 0) return "cannot read " + file_ + ": " + std::strerror(blocks_.error());
  if (!packed_.empty()) return fmt::format("{}: {}", file_, packed_);
  if (!packets_ || interface_ == "*") return "";
  const auto found = lines();
  const std::string_view kind =
      std::ranges::all_of(found, &PacketLines::Line::serial) ? "serial line" : "line";
  if (found.empty()) {
    const auto lost = packets_->damage("*");
    return file_ + ": none of its packets is of a serial line, of UDP or of TCP" +
           (lost.empty() ? "" : "; " + lost);
  }
  if (interface_.empty() && found.size() > 1)
    return fmt::format("{} has several {}s: {}; --interface chooses one, in a link interface=",
                       file_, kind, names_of(found));
  if (!interface_.empty() &&
      std::ranges::find(found, interface_, &PacketLines::Line::name) == found.end())
    return fmt::format("{} has no {} {}; it has {}", file_, kind, interface_, names_of(found));
  return "";
}

bool has_times(const std::string& file) {
  if (!is_regular(file)) return false;
  const auto first = LineFile(file, false, "*").next();
  return first && first->time;
}

bool has_packets(const std::string& file) {
  return is_regular(file) && PacketLines::recognises(FileBlocks(file).read());
}

}  // namespace drydock::capture
