#pragma once

#include <span>
#include <string>

#include "drivers/capture/byte_content.hpp"
#include "drivers/capture/file_blocks.hpp"

namespace drydock::capture {

/// The bytes of a line that a capture holds, read in pieces of any size.
class ByteFile {
 public:
  /// `raw`: the file to the byte.
  ByteFile(const std::string& file, bool raw) : blocks_(file), content_(raw) {}

  /// Fills as much of `into` as the file still has. 0: the end, or an error.
  std::size_t read(std::span<std::uint8_t> into);
  int error() const { return blocks_.error(); }  ///< errno; 0: none

 private:
  FileBlocks blocks_;
  ByteContent content_;
  wire::Bytes rest_;
};

}  // namespace drydock::capture
