#include "drivers/probe/unknown_file.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "drivers/capture/line_file.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::probe {
namespace {

using wire::Bytes;

constexpr bool is_upper(char c) { return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9'); }

bool is_printed(std::uint8_t byte) {
  return (byte >= 0x20 && byte < 0x7F) || byte == '\t' || byte == '\r' || byte == '\n';
}

/// `$GPHDT,75.5664,T`, with whatever stands before it.
bool lacks_checksum(std::string_view line) {
  constexpr std::size_t address = 5;
  const auto start = line.find_first_of("$!");
  if (start == line.npos || line.size() < start + address + 2) return false;
  const auto name = line.substr(start + 1, address);
  return std::ranges::all_of(name, is_upper) && line[start + 1 + address] == ',' &&
         line.find('*', start) == line.npos;
}

/// True if most lines are sentences without a checksum.
bool are_unchecked_sentences(std::string_view text) {
  std::size_t lines = 0, unchecked = 0;
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of("\r\n"), text.size());
    lines += end > 0;
    unchecked += lacks_checksum(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return unchecked > 0 && 2 * unchecked >= lines;
}

}  // namespace

std::string what_it_may_be(const std::string& file, bool raw) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) return "no protocol that we know";
  if (std::filesystem::file_size(file, none) == 0 && !none) return "the file is empty";
  capture::LineFile line(file, raw);
  const auto read = line.next();
  if (!read) return "the file holds no bytes but comments (format=raw keeps them)";
  const auto text = wire::as_text(read->bytes);
  if (are_unchecked_sentences(text))
    return "sentences of NMEA 0183 without checksums, so nothing tells a damaged one: let the "
           "sensor send checksums, or describe its sentences (drydock describe)";
  const auto printed = std::ranges::count_if(read->bytes, is_printed);
  constexpr double nearly_all = 0.95;
  const bool is_text =
      static_cast<double>(printed) >= nearly_all * static_cast<double>(read->bytes.size());
  return std::string(is_text ? "text, but of no protocol and no capture format that we know"
                             : "bytes, but of no protocol that we know, or recorded at a wrong "
                               "baud rate") +
         ": docs/use/captures.md has the formats, drydock describe drafts a description";
}

}  // namespace drydock::probe
