#include "hil/campaign/slurm/shard_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "hil/report/write_file.hpp"

namespace drydock::campaign {
namespace {

[[noreturn]] void refuse_range(const std::string& text) {
  throw std::runtime_error(fmt::format("'{}' is no list of runs, allowed: 0-3,7", text));
}

std::size_t run_number(std::string_view text, const std::string& all) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) refuse_range(all);
  return value;
}

}  // namespace

std::string to_ranges(std::span<const std::size_t> indexes) {
  std::string text;
  for (std::size_t i = 0, end = 0; i < indexes.size(); i = end) {
    for (end = i + 1; end < indexes.size() && indexes[end] == indexes[end - 1] + 1;) ++end;
    text += text.empty() ? "" : ",";
    text += end == i + 1 ? fmt::format("{}", indexes[i])
                         : fmt::format("{}-{}", indexes[i], indexes[end - 1]);
  }
  return text;
}

std::vector<std::size_t> read_ranges(const std::string& text) {
  std::vector<std::size_t> indexes;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const auto dash = part.find('-');
    const auto first = run_number(std::string_view(part).substr(0, dash), text);
    const auto last = dash == std::string::npos
                          ? first
                          : run_number(std::string_view(part).substr(dash + 1), text);
    for (std::size_t i = first; i <= last; ++i) indexes.push_back(i);
  }
  return indexes;
}

std::size_t write_shards(const std::filesystem::path& list, std::span<const std::size_t> indexes,
                         std::size_t size) {
  std::string text;
  std::size_t shards = 0;
  for (std::size_t i = 0; i < indexes.size(); i += size, ++shards)
    text += to_ranges(indexes.subspan(i, std::min(size, indexes.size() - i))) + "\n";
  report::write_file(list, text);
  return shards;
}

std::vector<std::size_t> read_shard(const std::filesystem::path& list, std::size_t shard) {
  std::ifstream file(list);
  std::string line;
  for (std::size_t i = 0; i <= shard; ++i)
    if (!std::getline(file, line))
      throw std::runtime_error(fmt::format("{} has no shard {}", list.string(), shard));
  return read_ranges(line);
}

}  // namespace drydock::campaign
