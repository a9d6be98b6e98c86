#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/conformance/corpus.hpp"
#include "tests/conformance/reading.hpp"

namespace drydock::conformance {

/// A CAN frame of a table with the columns id, payload, meaning. The meaning is in words.
struct FrameVector {
  std::size_t line = 0;
  unsigned id = 0;
  std::vector<std::uint8_t> data;
  std::string words;
};

/// Tables (*.tsv) of such frames.
std::vector<Case> frame_vector_files(const fs::path& folder);

/// The lines with a frame. An identifier `180h+node` is that of node 1.
std::vector<FrameVector> read_frame_vectors(const fs::path& table);

/// In the form of `candump -L`.
std::string candump_line(const FrameVector& vector);

}  // namespace drydock::conformance
