#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/conformance/corpus.hpp"
#include "tests/conformance/reading.hpp"

namespace drydock::conformance {

/// A CAN frame of a table with the columns id, payload, meaning: in words what it should say.
struct FrameVector {
  std::size_t line = 0;
  unsigned id = 0;
  std::vector<std::uint8_t> data;
  std::string words;
};

/// Tables (*.tsv) of such frames.
std::vector<Case> frame_vector_files(const fs::path& folder);

/// The lines that hold a frame; an identifier `180h+node` is that of node 1.
std::vector<FrameVector> read_frame_vectors(const fs::path& table);

/// As `candump -L` writes it.
std::string candump_line(const FrameVector& vector);

}  // namespace drydock::conformance
