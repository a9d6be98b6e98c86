#include "drivers/probe/describe.hpp"

#include <fmt/format.h>

#include <cstring>

#include "drivers/capture/frame_capture.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/guess/bus_guess.hpp"
#include "drivers/guess/guess.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::probe {
namespace {

constexpr std::size_t enough_bytes = 1u << 22;

using Buffer = std::vector<std::uint8_t>;

void append(Buffer& all, wire::Bytes some) { all.insert(all.end(), some.begin(), some.end()); }

Buffer read_start(capture::FileBlocks& blocks) {
  Buffer bytes;
  for (wire::Bytes block = blocks.read(); !block.empty() && bytes.size() < enough_bytes;
       block = blocks.read())
    append(bytes, block);
  return bytes;
}

/// Of a CAN capture in any format. Empty: it is none.
std::string guess_bus(const Buffer& bytes) {
  capture::FrameCapture frames;
  frames.feed(bytes);
  frames.finish();
  guess::BusGuess guess;
  while (const auto record = frames.next()) guess.take(record->frame, record->time);
  return guess.dbc();
}

/// What a line carried. Trouble: a file of packets with several lines, or with none.
Buffer line_bytes(const std::string& file, const Buffer& bytes, std::string& trouble) {
  Buffer carried;
  if (!capture::has_packets(file)) {
    append(carried, capture::ByteContent(false).of(bytes));
    return carried;
  }
  capture::LineFile line(file, false);
  for (auto read = line.next(); read && carried.size() < enough_bytes; read = line.next())
    append(carried, read->bytes);
  trouble = line.trouble();
  return carried;
}

}  // namespace

int describe(const std::string& file, std::FILE* out, std::FILE* err) {
  capture::FileBlocks blocks(file);
  const Buffer bytes = read_start(blocks);
  if (blocks.error() != 0) {
    fmt::print(err, "describe: cannot read {}: {}\n", file, std::strerror(blocks.error()));
    return terminal::exit_failed;
  }
  std::string guess = guess_bus(bytes), trouble;
  if (guess.empty()) guess = guess::guess_description(line_bytes(file, bytes, trouble));
  if (!trouble.empty())
    fmt::print(err, "describe: {}\n", trouble);
  else if (guess.empty())
    fmt::print(err, "describe: {}: {} bytes without sentences or frames that repeat; record more\n",
               file, bytes.size());
  fmt::print(out, "{}", guess);
  return terminal::exit_of(!guess.empty());
}

}  // namespace drydock::probe
