#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

/// Shards: the missing runs in pieces, one for each task. The list of a submission is a file with a
/// line for each shard, so a task reads one line and not the journals of all others.
namespace drydock::campaign {

/// `0-3,7,9-10` of growing indexes.
std::string to_ranges(std::span<const std::size_t> indexes);

/// Throws std::runtime_error for any other text.
std::vector<std::size_t> read_ranges(const std::string& text);

/// Writes the shards of at most `size` runs each, and returns their number.
std::size_t write_shards(const std::filesystem::path& list, std::span<const std::size_t> indexes,
                         std::size_t size);

/// The runs of one shard. Throws std::runtime_error if the list does not have it.
std::vector<std::size_t> read_shard(const std::filesystem::path& list, std::size_t shard);

}  // namespace drydock::campaign
