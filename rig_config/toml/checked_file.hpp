#pragma once

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

/// Reads and checks files. The result is not yet typed values.
namespace drydock::rig_config {

enum class FileKind : std::uint8_t { rig, mission, sensor, vehicle, fault, device };

FileKind kind_of(const Node& root);  ///< by its top-level tables

Loaded<std::string> read_file(const std::string& path);

/// A document that passed the schema and the checks of its kind.
Loaded<Node> read_checked(std::string_view text, const std::string& path, FileKind kind,
                          const LoadOptions& options = {});
Loaded<Node> read_checked_file(const std::string& path, FileKind kind);

template <class T>
void append(std::vector<T>& to, std::vector<T> more) {
  std::ranges::move(more, std::back_inserter(to));
}

}  // namespace drydock::rig_config
