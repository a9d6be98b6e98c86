#include "tests/conformance/frame_vectors.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

namespace drydock::conformance {

namespace {

constexpr std::string_view heading = "id\tpayload\tmeaning";
constexpr std::string_view of_node = "h+node";

std::optional<unsigned> hex(std::string_view text) {
  unsigned value = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), value, 16).ptr;
  if (text.empty() || end != text.data() + text.size()) return {};
  return value;
}

std::optional<unsigned> identifier(std::string_view text) {
  if (!text.ends_with(of_node)) return hex(text);
  const auto base = hex(text.substr(0, text.size() - of_node.size()));
  return base ? std::optional{*base + 1} : base;
}

std::optional<FrameVector> read_line(const std::vector<std::string>& columns) {
  if (columns.size() < 3) return {};
  const auto id = identifier(columns[0]);
  const std::string& payload = columns[1];
  if (!id || payload.empty() || payload.size() % 2 != 0) return {};
  FrameVector vector{0, *id, {}, columns[2]};
  for (std::size_t i = 0; i < payload.size(); i += 2) {
    const auto byte = hex(std::string_view(payload).substr(i, 2));
    if (!byte) return {};
    vector.data.push_back(static_cast<std::uint8_t>(*byte));
  }
  return vector;
}

}  // namespace

std::vector<Case> frame_vector_files(const fs::path& folder) {
  auto tables = files_of(folder, ".tsv");
  std::erase_if(tables, [](const fs::path& table) {
    return read_text(table).find(heading) == std::string::npos;
  });
  return vectors(tables);
}

std::vector<FrameVector> read_frame_vectors(const fs::path& table) {
  std::vector<FrameVector> found;
  std::size_t number = 0;
  for (const std::string& line : lines_of(read_text(table))) {
    ++number;
    if (auto vector = read_line(split(line, '\t'))) {
      vector->line = number;
      found.push_back(std::move(*vector));
    }
  }
  return found;
}

std::string candump_line(const FrameVector& vector) {
  std::string line = fmt::format("(0.000000) can0 {:03X}#", vector.id);
  for (const std::uint8_t byte : vector.data) line += fmt::format("{:02X}", byte);
  return line + '\n';
}

}  // namespace drydock::conformance
