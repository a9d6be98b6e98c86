#pragma once

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// Lines of `candump -L` and `candump -l` (drivers/wire/can/candump.hpp). A line that begins with
/// '#' is a comment.
class CandumpLog final : public LineReader {
 public:
  static constexpr std::string_view name = "candump-log";
  static bool recognises(std::string_view line);

 private:
  Reading read_line(std::string_view line) override;
};

}  // namespace drydock::capture
