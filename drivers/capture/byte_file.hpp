#pragma once

#include <span>
#include <string>

#include "drivers/capture/line_file.hpp"

namespace drydock::capture {

/// The bytes of a line that a capture holds, read in pieces of any size.
class ByteFile {
 public:
  /// As LineFile.
  ByteFile(const std::string& file, bool raw, const std::string& interface = {})
      : line_(file, raw, interface) {}

  /// Fills as much of `into` as the file still has. 0: the end, or an error.
  std::size_t read(std::span<std::uint8_t> into);
  int error() const { return line_.error(); }  ///< errno; 0: none

 private:
  LineFile line_;
  wire::Bytes rest_;
};

}  // namespace drydock::capture
