#include "hil/replay/rigs/joined_capture.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "drivers/text/printable.hpp"
#include "hil/replay/rigs/file_times.hpp"
#include "hil/replay/rigs/joined_writer.hpp"

namespace drydock::replay {
namespace {

using measurement::Stamp;

/// So many usual steps without data are a gap.
constexpr int steps_of_gap = 3;

std::vector<FilePart> parts_in(const std::vector<std::string>& files,
                               const decode::ReplayOptions& how) {
  std::vector<FilePart> parts;
  for (const auto& file : files) {
    auto of_file = how;
    of_file.capture = file;
    parts.push_back({file, times_of_file(of_file)});
  }
  return parts;
}

/// One clock for all that tell times, with a date.
bool comparable(const std::vector<FilePart>& parts) {
  const FileTimes* known = nullptr;
  for (const auto& part : parts) {
    const auto& times = part.times;
    if (!times.told()) continue;
    if (!times.dated() || (known != nullptr && known->clock.pace != times.clock.pace)) return false;
    known = &times;
  }
  return known != nullptr;
}

/// One that tells no time stays behind the one before.
void put_in_order(std::vector<FilePart>& parts) {
  Stamp before = Stamp::min();
  for (auto& part : parts) before = part.begin = part.times.told() ? part.times.first : before;
  std::ranges::stable_sort(parts, {}, &FilePart::begin);
}

std::string names_of(const std::vector<FilePart>& parts) {
  std::vector<std::string> names;
  names.reserve(parts.size());
  for (const auto& part : parts) names.push_back(text::printable(part.file));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string without_times(const std::vector<FilePart>& parts) {
  std::vector<std::string> names;
  for (const auto& part : parts)
    if (!part.times.told()) names.push_back(text::printable(part.file));
  return names.empty() || names.size() == parts.size()
             ? ""
             : fmt::format("{}: tells no time, and stays behind the one before",
                           fmt::join(names, ", "));
}

/// Seconds between two captures; below zero they overlap.
std::string gap_text(const FilePart& before, const FilePart& part) {
  const auto gap = part.times.first - before.times.last;
  const auto step = std::max(before.times.step, part.times.step);
  if (step.count() == 0 || gap <= steps_of_gap * step) return {};
  return fmt::format("nothing for {:.1f} s between {} and {}", measurement::seconds(gap),
                     text::printable(before.file), text::printable(part.file));
}

std::string overlap_text(const FilePart& before, const FilePart& part, const Written& written) {
  const auto what = written.skips ? fmt::format("its {} {} of that time are left out",
                                                written.left_out, written.what)
                                  : "what both have comes twice";
  return fmt::format("{} begins {:.1f} s before {} ends: {}", text::printable(part.file),
                     measurement::seconds(before.times.last - part.times.first),
                     text::printable(before.file), what);
}

}  // namespace

JoinedCapture join(const std::vector<std::string>& files, const decode::ReplayOptions& how) {
  auto parts = parts_in(files, how);
  const bool in_order = comparable(parts);
  if (in_order) put_in_order(parts);
  JoinedCapture joined{std::make_shared<TemporaryFile>(), {}, names_of(parts), {}};
  const auto note = [&](std::string line) {
    if (!line.empty()) joined.notes.push_back(std::move(line));
  };
  note(fmt::format("{}: read as one, {}", joined.shown,
                   in_order ? "in the order of their times"
                            : "in the order given: no clock with a date tells another"));
  if (in_order) note(without_times(parts));
  JoinedWriter writer(joined.file->path(), parts, how);
  const FilePart* before = nullptr;  // the one that ends last
  for (const auto& part : parts) {
    const bool told = in_order && part.times.told();
    const bool overlaps = told && before != nullptr && part.times.first < before->times.last;
    const auto written =
        writer.add(part, overlaps ? std::optional(before->times.last) : std::nullopt);
    if (!written.damage.empty()) note(text::printable(part.file) + ": " + written.damage);
    if (!told) continue;
    if (before != nullptr)
      note(overlaps ? overlap_text(*before, part, written) : gap_text(*before, part));
    if (before == nullptr || part.times.last > before->times.last) before = &part;
  }
  joined.format = writer.finish();
  return joined;
}

}  // namespace drydock::replay
