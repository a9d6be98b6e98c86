#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/frame_capture.hpp"
#include "drivers/decode/decode.hpp"
#include "drivers/decode/following_times.hpp"
#include "drivers/measurement/stamp.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/interrupt_flag.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/text/printable.hpp"

/// What all ways to decode a CAN capture have in common.
namespace drydock::decode {

/// Reads CAN captures to their end, one behind the other. It calls `flush() -> bool` before it
/// waits for a live input. False if that failed.
template <class OnRecord, class Flush>
bool read_records(capture::FileBlocks& blocks, capture::FrameCapture& frames, FollowingTimes& times,
                  OnRecord&& on_record, Flush&& flush) {
  const auto drain = [&] {
    while (auto record = frames.next()) {
      if (record->time) record->time = times.of(*record->time);
      on_record(*record);
    }
  };
  for (wire::Bytes block = blocks.read(); !block.empty(); block = blocks.read()) {
    if (blocks.is_next_file()) {
      frames.settle();
      const bool anew = frames.begins_anew(block);
      if (anew) frames.finish();
      drain();
      if (anew) frames.restart();
      times.begin_file(blocks.file());
    }
    frames.feed(block);
    drain();
    if (frames.unknown()) return true;
    if (!blocks.likely_more(block) && !flush()) return false;
  }
  frames.finish();
  drain();
  return true;
}

/// The keys of every CAN message.
inline void put_record(text::JsonWriter& json, const capture::Record& record) {
  using Seconds = std::optional<double>;
  json.field("time_s", record.time ? Seconds(measurement::seconds(*record.time)) : Seconds());
  json.field("interface", record.interface);
}

/// The text of a file that describes messages. It may be one block longer than `most`; the reader
/// then says that it is too long.
inline std::string contents(capture::FileBlocks& blocks, std::size_t most) {
  std::string text;
  for (auto block = blocks.read(); !block.empty(); block = blocks.read()) {
    text.append(block.begin(), block.end());
    if (text.size() > most) break;
  }
  return text;
}

inline std::vector<std::string> files_of(const DecodeOptions& options) {
  std::vector<std::string> files{options.file};
  files.insert(files.end(), options.more.begin(), options.more.end());
  return files;
}

/// For messages: "standard input", "can.log", "can.000 and 2 more".
inline std::string name_of(const DecodeOptions& options) {
  const std::string first = options.file.empty() ? "standard input" : options.file;
  return options.more.empty() ? first : fmt::format("{} and {} more", first, options.more.size());
}

inline void print_notes(std::FILE* err, const FollowingTimes& times) {
  for (const auto& note : times.notes()) fmt::print(err, "{}\n", text::printable(note));
}

inline std::string cannot_read(const std::string& file, int error) {
  return fmt::format("cannot read {}: {}", file.empty() ? "standard input" : file,
                     std::strerror(error));
}

inline int refuse(std::FILE* err, const std::string& why, int code = terminal::exit_usage) {
  fmt::print(err, "decode: {}\n", why);
  return code;
}

/// Decodes the capture of the options with `messages`, which has receive(record), flush() -> bool,
/// finish(), print_totals(err, capture) and total(). Returns the exit code.
template <class Messages>
int decode_frames(Messages& messages, const DecodeOptions& options, std::FILE* err) {
  const capture::Format* format = capture::find_format(options.format);
  if (!options.format.empty() && format == nullptr)
    return refuse(err, fmt::format("no format \"{}\" of CAN captures, allowed: {}", options.format,
                                   capture::format_names()));
  capture::FileBlocks blocks(files_of(options));
  const terminal::InterruptFlag interrupt;
  blocks.end_when([&] { return interrupt.set(); });
  capture::FrameCapture capture(format);
  FollowingTimes times;
  const bool read = read_records(
      blocks, capture, times, [&](const capture::Record& record) { messages.receive(record); },
      [&] { return messages.flush(); });
  messages.finish();
  if (blocks.error() != 0)
    return refuse(err, cannot_read(blocks.file(), blocks.error()), terminal::exit_failed);
  if (capture.unknown())
    return refuse(err, capture::unknown_format_text(name_of(options), capture),
                  terminal::exit_failed);
  if (!read || !messages.flush())
    return refuse(err, "cannot write the output", terminal::exit_failed);
  if (!options.quiet) {
    messages.print_totals(err, capture);
    const std::string damage = capture::damage_text(capture.tally());
    if (!damage.empty()) fmt::print(err, "{}\n", damage);
    print_notes(err, times);
  }
  return terminal::exit_of(messages.total() > 0);
}

}  // namespace drydock::decode
