#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <cstring>
#include <optional>
#include <string>

#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/frame_capture.hpp"
#include "drivers/measurement/stamp.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_lines.hpp"

/// What both ways to decode a CAN capture have in common.
namespace drydock::decode {

/// Reads a CAN capture to its end. It calls `flush() -> bool` before it waits for a live input.
/// False if that failed.
template <class OnRecord, class Flush>
bool read_records(capture::FileBlocks& blocks, capture::FrameCapture& frames, OnRecord&& on_record,
                  Flush&& flush) {
  const auto drain = [&] {
    while (const auto record = frames.next()) on_record(*record);
  };
  for (wire::Bytes block = blocks.read(); !block.empty(); block = blocks.read()) {
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

inline std::string cannot_read(const std::string& file, int error) {
  return fmt::format("cannot read {}: {}", file, std::strerror(error));
}

inline int refuse(std::FILE* err, const std::string& why, int code = terminal::exit_usage) {
  fmt::print(err, "decode: {}\n", why);
  return code;
}

}  // namespace drydock::decode
