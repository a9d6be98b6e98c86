#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/capture/reader.hpp"

/// Every format of CAN captures by its name. A new one adds its entry in format.cpp.
namespace drydock::capture {

struct Format {
  std::string_view name;
  std::unique_ptr<Reader> (*make)();
  /// Where in the head of a file a magic or, from `from` on, a line stands that this format has;
  /// empty: nowhere.
  std::optional<std::size_t> (*first_sign)(Bytes head, std::size_t from, bool is_whole_file);
};

std::span<const Format> formats();
const Format* find_format(std::string_view name);
/// "pcap, pcapng, candump-log, ...", for messages and help.
std::string format_names();

constexpr std::size_t head_to_recognise = 64 * 1024;
constexpr std::size_t longest_magic = 24;  ///< no less is looked at, unless the file has no more

/// The format whose sign comes first in the head of a file; null if there is none in it. A head
/// that grows need not be searched again: `from` is past_whole_lines() of what was searched before.
const Format* recognise(Bytes head, bool is_whole_file, std::size_t from = 0);

/// The end of the last whole line that begins at `from` or behind it.
std::size_t past_whole_lines(Bytes head, std::size_t from);

}  // namespace drydock::capture
