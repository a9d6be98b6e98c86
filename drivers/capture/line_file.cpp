#include "drivers/capture/line_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <utility>

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

LineFile::LineFile(std::vector<std::string> files, bool raw, std::string interface)
    : files_(std::move(files)),
      interface_(std::move(interface)),
      raw_(raw),
      blocks_(files_),
      content_(raw) {}

/// "dive.000", "dive.000 and 2 more".
std::string LineFile::name() const {
  const std::string first = files_.empty() ? "" : files_.front();
  return files_.size() < 2 ? first : fmt::format("{} and {} more", first, files_.size() - 1);
}

void LineFile::begin() {
  begun_ = true;
  const Bytes first = blocks_.read();
  next_ = first;
  if (!raw_) packed_ = wire::packed_content(wire::as_text(first));
  const bool as_text = !raw_ && PacketText::recognises(first);
  if (raw_ || (!as_text && !PacketLines::recognises(first))) return;
  packets_.emplace(first);
  if (as_text)
    text_.emplace().feed(first);
  else
    buffer_.assign(first.begin(), first.end());
  if (interface_.empty() && std::ranges::all_of(files_, is_regular)) choose();
}

/// Looks at the whole file: if one line alone says something, it is that one.
void LineFile::choose() {
  LineFile whole(files_, false, "*");
  whole.end_when(ended_);
  while (whole.next()) continue;
  const auto lines = whole.lines();
  const auto speaks = [](const auto& line) { return line.bytes > 0; };
  if (std::ranges::count_if(lines, speaks) == 1)
    interface_ = std::ranges::find_if(lines, speaks)->name;
}

std::optional<LineFile::Read> LineFile::next() {
  if (!begun_) begin();
  if (packets_) return next_packet();
  while (packed_.empty() && mixed_.empty()) {
    if (const auto part = next_part()) return part;
    const auto known = std::exchange(next_, std::nullopt);
    const Bytes block = known ? *known : blocks_.read();
    if (!known && blocks_.is_next_file() && !begin_file(block)) continue;
    block_ = block.empty() ? content_.finish() : content_.of(block);
    part_ = part_from_ = 0;
    if (block.empty() && block_.empty()) break;
  }
  return {};
}

/// A file behind the first one. False: it does not go on where the one before ended, whose rest
/// comes first.
bool LineFile::begin_file(Bytes block) {
  if (raw_) return true;
  packed_ = wire::packed_content(wire::as_text(block));
  if (PacketLines::recognises(block))
    mixed_ = blocks_.file() + " is a file of packets, and the one before it holds bytes";
  if (!packed_.empty() || !mixed_.empty()) return false;
  if (!content_.begins_anew(block)) return true;
  const Bytes rest = content_.finish();
  rest_.assign(rest.begin(), rest.end());
  notes_ = note();
  content_ = ByteContent(raw_);
  block_ = rest_;
  part_ = part_from_ = 0;
  next_ = block;
  return false;
}

std::string LineFile::note() const {
  if (text_) return "packets of a network, as tcpdump or tshark printed them";
  const std::string last = content_.note();
  return notes_ + (notes_.empty() || last.empty() ? "" : "\n") + last;
}

std::string LineFile::cut_note() const {
  return cut_ == 0
             ? ""
             : fmt::format("{} ends inside of a packet: {} bytes are no whole one", name(), cut_);
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

std::optional<PacketLines::Piece> LineFile::next_of_text() {
  for (bool at_end = false;;) {
    while (const auto packet = text_->next())
      if (const auto piece = packets_->take(*packet)) return piece;
    if (at_end) return packets_->finish();
    const Bytes block = blocks_.read();
    at_end = block.empty();
    if (at_end)
      text_->finish();
    else
      text_->feed(block);
  }
}

std::optional<PacketLines::Piece> LineFile::next_piece() {
  if (text_) return next_of_text();
  for (;;) {
    const Bytes rest = Bytes{buffer_}.subspan(at_);
    const Scan scan = packets_->scan(rest);
    if (scan.kind == Scan::Kind::need_more) {
      buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
      at_ = 0;
      const Bytes block = blocks_.read();
      const bool anew = blocks_.is_next_file() && PacketLines::recognises(block);
      if (block.empty() || anew) {
        cut_ += buffer_.size();
        buffer_.clear();
      }
      if (block.empty()) return packets_->finish();
      if (anew) packets_->begin_file(block);
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
  if (blocks_.error() != 0)
    return "cannot read " + blocks_.file() + ": " + std::strerror(blocks_.error());
  if (!packed_.empty()) return fmt::format("{}: {}", blocks_.file(), packed_);
  if (!mixed_.empty()) return mixed_;
  if (!packets_ || interface_ == "*") return "";
  const auto found = lines();
  const std::string_view kind =
      std::ranges::all_of(found, &PacketLines::Line::serial) ? "serial line" : "line";
  if (found.empty()) {
    const auto lost = packets_->damage("*");
    return name() + ": none of its packets is of a serial line, of UDP or of TCP" +
           (lost.empty() ? "" : "; " + lost);
  }
  if (interface_.empty() && found.size() > 1)
    return fmt::format("{} has several {}s: {}; --interface chooses one, in a link interface=",
                       name(), kind, names_of(found));
  if (!interface_.empty() &&
      std::ranges::find(found, interface_, &PacketLines::Line::name) == found.end())
    return fmt::format("{} has no {} {}; it has {}", name(), kind, interface_, names_of(found));
  return "";
}

bool has_times(const std::string& file) {
  if (!is_regular(file)) return false;
  const auto first = LineFile(file, false, "*").next();
  return first && first->time;
}

bool has_packets(const std::string& file) {
  if (!is_regular(file)) return false;
  FileBlocks blocks(file);
  const Bytes head = blocks.read();
  return PacketLines::recognises(head) || PacketText::recognises(head);
}

}  // namespace drydock::capture
