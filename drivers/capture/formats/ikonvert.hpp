#pragma once

#include "drivers/capture/formats/message_frames.hpp"
#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// Lines of Digital Yacht's iKonvert: PGN, priority, source, destination, seconds since the gateway
/// started, and the whole message in base64 (RFC 4648), with and without its padding.
///    !PDGY,127257,3,17,255,0.563,AP9/UgAh/v8=
/// A line with four fields is what the computer wants to send: PGN, destination and data. $PDGY
/// lines are states and settings of the gateway. Neither was on the bus.
class Ikonvert final : public LineReader {
 public:
  static constexpr std::string_view name = "ikonvert";
  static bool recognises(std::string_view line);

  std::optional<Record> more() override { return frames_.more(); }

 private:
  Reading read_line(std::string_view line) override;

  MessageFrames frames_;
};

}  // namespace drydock::capture
