#pragma once

#include "drivers/capture/formats/message_frames.hpp"
#include "drivers/capture/reader.hpp"
#include "drivers/wire/day_clock.hpp"

namespace drydock::capture {

/// "N2K ASCII" of Actisense's gateways: time of day, source, destination and priority, PGN, data.
///    A173321.107 23FF7 1F513 012F3070002F30709F
/// Every line is a whole message.
class ActisenseAscii final : public LineReader {
 public:
  static constexpr std::string_view name = "actisense";
  static bool recognises(std::string_view line);

  std::optional<Record> more() override { return frames_.more(); }

 private:
  Reading read_line(std::string_view line) override;

  wire::DayClock clock_;
  MessageFrames frames_;
};

}  // namespace drydock::capture
