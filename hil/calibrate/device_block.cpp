#include "hil/calibrate/device_block.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace drydock::calibrate {
namespace {

using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  for (std::size_t from = 0; from < text.size();) {
    const auto end = std::min(text.find('\n', from), text.size() - 1);
    lines.push_back(text.substr(from, end + 1 - from));
    from = end + 1;
  }
  return lines;
}

std::string trimmed(const std::string& line) {
  const auto first = line.find_first_not_of(" \t");
  return first == std::string::npos ? "" : line.substr(first);
}

bool begins_table(const std::string& line) { return trimmed(line).starts_with('['); }

/// True if the line sets this key.
bool sets(const std::string& line, const std::string& key) {
  const auto text = trimmed(line);
  if (!text.starts_with(key)) return false;
  const auto next = text.find_first_not_of(" \t", key.size());
  return next != std::string::npos && text[next] == '=';
}

bool names(const std::string& line, const std::string& device) {
  return sets(line, "name") && line.find('"' + device + '"') != std::string::npos;
}

/// The line with the device's name, and the end of the block's own keys.
struct Block {
  std::size_t name, end;
};

Block block_of(const Lines& lines, const std::string& device) {
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!trimmed(lines[i]).starts_with("[[device]]")) continue;
    std::size_t end = i + 1, name = 0;
    for (; end < lines.size() && !begins_table(lines[end]); ++end)
      if (names(lines[end], device)) name = end;
    if (name > 0) return {name, end};
  }
  throw std::runtime_error("the rig file has no [[device]] named " + device);
}

/// Whether the block's key is written as a table of its own behind it.
bool has_table(const Lines& lines, const Block& block, const std::string& key) {
  for (std::size_t i = block.end; i < lines.size(); ++i) {
    const auto text = trimmed(lines[i]);
    if (text.starts_with("[[")) return false;
    if (text.starts_with("[device." + key + "]")) return true;
  }
  return false;
}

std::string comment_of(const std::string& line) {
  const auto hash = line.find('#');
  return hash == std::string::npos ? "" : "  " + line.substr(hash, line.find('\n') - hash);
}

}  // namespace

std::string with_key(const std::string& rig, const std::string& device, const std::string& key,
                     const std::string& value) {
  Lines lines = lines_of(rig);
  const Block block = block_of(lines, device);
  const auto cannot = [&] {
    return std::runtime_error(device + ": " + key + " is no single line");
  };
  if (has_table(lines, block, key)) throw cannot();
  const std::string line = key + " = " + value;
  for (std::size_t i = block.name + 1; i < block.end; ++i) {
    if (!sets(lines[i], key)) continue;
    if (std::ranges::count(lines[i], '[') != std::ranges::count(lines[i], ']')) throw cannot();
    lines[i] = line + comment_of(lines[i]) + "\n";
    std::string text;
    for (const auto& one : lines) text += one;
    return text;
  }
  lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(block.name) + 1, line + "\n");
  std::string text;
  for (const auto& one : lines) text += one;
  return text;
}

}  // namespace drydock::calibrate
