#pragma once

#include <chrono>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace drydock::info {

/// What one serial line of a pcapng file brought.
struct LineInfo {
  std::string name, damage;
  bool serial = true;
  std::uint64_t reads = 0, bytes = 0;
  std::optional<std::chrono::nanoseconds> first, last;  ///< UTC since 1970
};

/// Of every serial line in the file. Empty: it is no pcapng file, or has none.
std::vector<LineInfo> line_infos(const std::string& file);

std::string to_text(const std::string& file, const std::vector<LineInfo>& lines);
nlohmann::json json_of(const std::vector<LineInfo>& lines);
std::string to_json(const std::string& file, const std::vector<LineInfo>& lines);

}  // namespace drydock::info
