#include "hil/replay/rigs/joined_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <stdexcept>

#include "drivers/capture/byte_file.hpp"
#include "drivers/capture/capture_file.hpp"
#include "drivers/wire/can/candump.hpp"
#include "hil/replay/rigs/packet_extent.hpp"

namespace drydock::replay {
namespace {

using measurement::Stamp;
using std::chrono::nanoseconds;

constexpr std::string_view pcapng_magic{"\x0A\x0D\x0D\x0A", 4};

/// Frames of a capture without times come at the times that their device tells.
Stamp time_of(const capture::Record& record) { return Stamp{record.time.value_or(nanoseconds{0})}; }

/// A line of candump has blanks between its words.
std::string one_word(std::string_view name) {
  std::string word(name.empty() ? "can" : name);
  std::ranges::replace(word, ' ', '_');
  return word;
}

/// The last message of the device's clock that is not later; null: none is.
const measurement::MessageTime* last_until(const measurement::MessageTimes& messages, Stamp end) {
  const auto later =
      std::ranges::upper_bound(messages, end.time_since_epoch(), {}, &measurement::MessageTime::at);
  return later == messages.begin() ? nullptr : &*std::prev(later);
}

std::uint64_t count_until(const measurement::MessageTimes& messages, Stamp end) {
  return static_cast<std::uint64_t>(std::ranges::count_if(
      messages, [&](const auto& message) { return message.at <= end.time_since_epoch(); }));
}

/// One that tells no time has nothing that would need one.
bool has_own_times(const std::vector<FilePart>& parts) {
  const auto is_by = [](shell::Pace pace) {
    return [pace](const FilePart& part) { return part.times.clock.pace == pace; };
  };
  return std::ranges::any_of(parts, is_by(shell::Pace::arrival)) &&
         std::ranges::none_of(parts, is_by(shell::Pace::device));
}

}  // namespace

JoinedWriter::JoinedWriter(const std::string& path, const std::vector<FilePart>& parts,
                           const decode::ReplayOptions& how)
    : out_(path, std::ios::binary), how_(how) {
  const auto& first = parts.front().times;
  const bool packets =
      std::ranges::any_of(parts, [](const auto& part) { return part.times.packets; });
  frames_ = !packets && first.travels == device::Travels::as_frames;
  copies_ = packets || (!frames_ && has_own_times(parts));
}

Written JoinedWriter::add(const FilePart& part, std::optional<Stamp> after) {
  if (frames_) return add_frames(part, after);
  if (!copies_) return add_bytes(part, after);
  return copy(part);
}

Written JoinedWriter::add_frames(const FilePart& part, std::optional<Stamp> after) {
  const bool counts_from_start =
      part.times.clock.pace == shell::Pace::arrival && !part.times.dated();
  const nanoseconds moved = counts_from_start ? frames_end_ : nanoseconds{0};
  const bool by_device = part.times.clock.pace == shell::Pace::device;
  const auto* known =
      after && by_device ? last_until(part.times.clock.times.messages, *after) : nullptr;
  const std::uint64_t known_frames = known != nullptr ? known->through : 0;
  capture::CaptureFile file(part.file, how_.format, how_.interface);
  Written written{.skips = true, .what = "frames"};
  std::array<std::uint8_t, wire::candump::longest_line> line;
  for (std::uint64_t frames = 1; const auto record = file.next(); ++frames) {
    if (after && (by_device ? frames <= known_frames : time_of(*record) <= *after)) {
      ++written.left_out;
      continue;
    }
    const nanoseconds at = time_of(*record).time_since_epoch() + moved;
    frames_end_ = std::max(frames_end_, at + part.times.step);
    const auto name = one_word(record->interface);
    const auto size = wire::candump::encode({at, name, record->frame}, line);
    out_.write(reinterpret_cast<const char*>(line.data()), static_cast<std::streamsize>(size));
  }
  if (const auto trouble = file.trouble(); !trouble.empty()) throw std::runtime_error(trouble);
  written.damage = capture::damage_text(file.frames().tally());
  return written;
}

Written JoinedWriter::add_bytes(const FilePart& part, std::optional<Stamp> after) {
  Written written{.skips = true, .what = "messages"};
  std::uint64_t known = 0;
  if (const auto& messages = part.times.clock.times.messages; after)
    if (const auto* last = last_until(messages, *after)) {
      known = last->through;
      written.left_out = count_until(messages, *after);
    }
  capture::ByteFile file(part.file, how_.format == "raw", how_.interface);
  std::array<std::uint8_t, 65536> block;
  while (const std::size_t size = file.read(block)) {
    const auto from = static_cast<std::size_t>(std::min<std::uint64_t>(known, size));
    known -= from;
    out_.write(reinterpret_cast<const char*>(block.data()) + from,
               static_cast<std::streamsize>(size - from));
  }
  if (file.error() != 0) throw std::runtime_error("cannot read " + part.file);
  return written;
}

namespace {

[[noreturn]] void refuse_other_kind(const std::string& file) {
  throw std::runtime_error(
      file +
      ": it is of another kind than the file before; mergecap makes one file of several pcap and "
      "pcapng files");
}

void copy_bytes(std::istream& in, std::ostream& out, std::uint64_t size) {
  std::array<char, 65536> block;
  while (size > 0 && in.read(block.data(), static_cast<std::streamsize>(
                                               std::min<std::uint64_t>(size, block.size())))) {
    out.write(block.data(), in.gcount());
    size -= static_cast<std::uint64_t>(in.gcount());
  }
}

}  // namespace

/// A pcapng file may have several sections, and a log goes on; a pcap file has one head.
Written JoinedWriter::copy(const FilePart& part) {
  Written written;
  std::ifstream in(part.file, std::ios::binary);
  if (capture::has_packets(part.file)) {
    std::string head(pcap_head, '\0');
    in.read(head.data(), pcap_head);
    const bool sections = head.starts_with(pcapng_magic);
    if (sections) head = pcapng_magic;
    if (head_ && *head_ != head) refuse_other_kind(part.file);
    const std::uint64_t from = sections || !head_ ? 0 : pcap_head;
    in.seekg(static_cast<std::streamoff>(from));
    head_ = head;
    const std::uint64_t end = packet_extent(part.file);
    copy_bytes(in, out_, end - std::min(from, end));
    if (const auto size = std::filesystem::file_size(part.file); size > end)
      written.damage =
          fmt::format("its last packet is cut short, {} bytes are left out", size - end);
    return written;
  }
  if (head_) refuse_other_kind(part.file);
  if (in.peek() != std::ifstream::traits_type::eof()) out_ << in.rdbuf();
  return written;
}

std::string JoinedWriter::finish() {
  out_.close();
  if (!out_) throw std::runtime_error("cannot write the joined captures into a temporary file");
  if (frames_) return "candump-log";
  return copies_ ? how_.format : "raw";
}

}  // namespace drydock::replay
