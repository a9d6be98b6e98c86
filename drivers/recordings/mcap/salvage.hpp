#pragma once

#include <istream>
#include <optional>
#include <vector>

#include "drivers/recordings/mcap/format.hpp"

/// What a reader still finds in a damaged file.
namespace drydock::mcap {

/// Where the first chunk at or behind `from` begins [B]: a head whose lengths fit together. Empty:
/// there is none before `size`, the end of the file. Moves the stream's position.
std::optional<std::uint64_t> find_chunk(std::istream& file, std::uint64_t from, std::uint64_t size);

/// Schemas and channels as the summary at the end of a file of `size` bytes repeats them, and the
/// attachments that it points at. Empty if the end is cut or damaged. Moves the stream's position.
std::vector<Record> definitions(std::istream& file, std::uint64_t size);

}  // namespace drydock::mcap
