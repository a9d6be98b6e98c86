#pragma once

#include "drivers/capture/formats/message_frames.hpp"
#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// canboat's plain text of NMEA 2000: time, priority, PGN, source, destination, length, data.
///    2022-09-28-11:36:59.668,5,130311,35,255,8,c5,c0,1c,6e,ff,7f,ff,ff
///    2011-04-25-06:25:03.603,3,129029,36,255,43,e6,f1,3a,...
/// canboat's `convert --to plain` leaves the time empty where it converts a dump without times. The
/// raw log of a Signal K server has a mark in front, `1731371761185;A;`, which is passed over.
/// A line of up to 8 bytes is a frame. A longer line ("fast") is a message that canboat has
/// assembled. Behind such a line a short one of a PGN that travels as fast packets is a whole
/// message as well.
class CanboatPlain final : public LineReader {
 public:
  static constexpr std::string_view name = "canboat";
  static bool recognises(std::string_view line);

  std::optional<Record> more() override { return frames_.more(); }

 private:
  Reading read_line(std::string_view line) override;

  MessageFrames frames_;
  bool assembled_ = false;  ///< a message of more than 8 bytes came
};

}  // namespace drydock::capture
