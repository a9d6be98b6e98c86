#include "hil/replay/rigs/capture_parts.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>

#include "drivers/capture/capture_file.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/text/printable.hpp"

namespace drydock::replay {
namespace {

constexpr const char* raw_bytes = "raw";

void add_buses(const std::string& file, const std::string& format,
               std::vector<CapturePart>& parts) {
  capture::CaptureFile capture(file, format, "");
  std::map<std::string, std::uint64_t, std::less<>> buses;
  while (const auto record = capture.next()) {
    auto bus = buses.find(record->interface);
    if (bus == buses.end()) bus = buses.emplace(std::string(record->interface), 0).first;
    ++bus->second;
  }
  for (const auto& [name, frames] : buses) parts.push_back({file, name, true, frames});
}

void add_lines(const std::string& file, std::vector<CapturePart>& parts) {
  capture::LineFile all(file, false, "*");
  while (all.next()) continue;
  for (const auto& line : all.lines())
    if (line.bytes > 0) parts.push_back({file, line.name, false, line.bytes});
}

/// Throws where the file cannot be read.
void add_bytes(const std::string& file, bool raw, std::vector<CapturePart>& parts) {
  capture::LineFile line(file, raw);
  CapturePart part{file};
  while (const auto read = line.next()) part.amount += read->bytes.size();
  if (const auto trouble = line.trouble(); !trouble.empty()) throw std::runtime_error(trouble);
  if (part.amount > 0) parts.push_back(part);
}

}  // namespace

std::string in_words(const CapturePart& part) {
  return fmt::format("{}{}{} ({} {})", text::printable(part.shown.empty() ? part.file : part.shown),
                     part.name.empty() ? "" : ", ", text::printable(part.name), part.amount,
                     part.frames ? "frames" : "bytes");
}

std::vector<CapturePart> parts_of(const std::string& file, const std::string& format) {
  std::vector<CapturePart> parts;
  const bool raw = format == raw_bytes;
  if (!raw) add_buses(file, format, parts);
  if (!raw && format.empty() && capture::has_packets(file))
    add_lines(file, parts);
  else if (parts.empty() && (raw || format.empty()))
    add_bytes(file, raw, parts);
  if (parts.empty())
    throw std::runtime_error(fmt::format(
        "{}: neither frames nor bytes of a line in it; drydock info tells what it is", file));
  for (auto& part : parts) part.format = format;
  return parts;
}

std::uint64_t measurements_of(const CapturePart& part, decode::ReplayOptions how) {
  how.capture = part.file;
  how.interface = part.name;
  how.format = part.format;
  std::uint64_t measurements = 0;
  decode::play(how, [&](const measurement::Measurement&) { ++measurements; });
  return measurements;
}

}  // namespace drydock::replay
