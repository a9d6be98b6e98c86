#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/capture/reader.hpp"

/// Every format of CAN captures by its name. For a new format, add an entry in format.cpp.
namespace drydock::capture {

struct Format {
  std::string_view name;
  std::unique_ptr<Reader> (*make)();
  /// Searches the head of a file for this format: a magic, or a line of it at `from` or later, but
  /// before `before`. Gives the position of the first sign. Empty if there is none.
  std::optional<std::size_t> (*first_sign)(Bytes head, std::size_t from, std::size_t before,
                                           bool is_whole_file);
  bool has_magic;  ///< it is no text
};

std::span<const Format> formats();
const Format* find_format(std::string_view name);
/// "pcap, pcapng, candump-log, ...", for messages and help.
std::string format_names();

constexpr std::size_t head_to_recognise = 64 * 1024;
constexpr std::size_t longest_magic = 24;  ///< fewer bytes are searched only in a shorter file

/// The format whose sign comes first in the head of a file. Null if there is no sign. When the head
/// grows, the old part need not be searched again: `from` is past_whole_lines() of that part.
const Format* recognise(Bytes head, bool is_whole_file, std::size_t from = 0);

/// The end of the last complete line that begins at `from` or later.
std::size_t past_whole_lines(Bytes head, std::size_t from);

}  // namespace drydock::capture
