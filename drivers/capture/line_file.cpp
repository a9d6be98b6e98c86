#include "drivers/capture/line_file.hpp"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace drydock::capture {

LineFile::LineFile(const std::string& file, bool raw, std::string interface)
    : file_(file), interface_(std::move(interface)), raw_(raw), blocks_(file), content_(raw) {}

bool LineFile::begin() {
  begun_ = true;
  first_ = blocks_.read();
  packets_ = !raw_ && Pcapng::recognises(first_);
  if (packets_) buffer_.assign(first_.begin(), first_.end());
  return packets_;
}

std::optional<LineFile::Read> LineFile::next() {
  const bool at_start = !begun_;
  if (at_start) begin();
  if (packets_) return next_packet();
  for (Bytes block = at_start ? first_ : blocks_.read(); !block.empty(); block = blocks_.read())
    if (const Bytes bytes = content_.of(block); !bytes.empty()) return Read{std::nullopt, bytes};
  return {};
}

std::optional<LineFile::Read> LineFile::next_packet() {
  for (;;) {
    const Bytes rest = Bytes{buffer_}.subspan(at_);
    const Scan scan = pcapng_.scan(rest, false);
    if (scan.kind == Scan::Kind::need_more) {
      buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
      at_ = 0;
      const Bytes block = blocks_.read();
      if (block.empty()) return {};
      buffer_.insert(buffer_.end(), block.begin(), block.end());
      continue;
    }
    at_ += scan.size;
    if (scan.kind != Scan::Kind::frame) continue;
    if (const auto read = take(rest.first(scan.size))) return read;
  }
}

/// Of several lines the one that was asked for; without a choice none, which trouble() tells.
std::optional<LineFile::Read> LineFile::take(Bytes unit) {
  pcapng_.read(unit);
  const auto serial = pcapng_.serial(unit);
  if (!serial || serial->sent || serial->bytes.empty()) return {};
  const bool chosen =
      interface_.empty() ? pcapng_.serial_lines().size() == 1 : serial->interface == interface_;
  return chosen ? std::optional(Read{serial->time, serial->bytes}) : std::nullopt;
}

std::string LineFile::trouble() const {
  if (blocks_.error() != 0) return "cannot read " + file_ + ": " + std::strerror(blocks_.error());
  if (!packets_) return "";
  const auto lines = pcapng_.serial_lines();
  std::string names;
  for (const auto& name : lines) names += (names.empty() ? "" : ", ") + name;
  if (lines.empty()) return file_ + ": this pcapng file has no serial line";
  if (interface_.empty() && lines.size() > 1)
    return file_ + " has several serial lines: " + names + "; --interface chooses one";
  if (!interface_.empty() && std::ranges::find(lines, interface_) == lines.end())
    return file_ + " has no serial line " + interface_ + "; it has " + names;
  return "";
}

bool is_pcapng(const std::string& file) {
  std::error_code none;
  return std::filesystem::is_regular_file(file, none) &&
         Pcapng::recognises(FileBlocks(file).read());
}

}  // namespace drydock::capture
