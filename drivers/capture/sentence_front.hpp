#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "drivers/capture/text_line.hpp"
#include "drivers/wire/codec.hpp"

/// What loggers write in front of the lines of a text, told from the begin of it.
namespace drydock::capture {

enum class SentenceFront : std::uint8_t { nothing, stamp, tag_block, time_lines };

/// What the whole lines of the text have in front of a sentence of NMEA 0183: a stamp if nearly all
/// lines have one, or the time of one, and a quarter a right checksum behind it; times on lines of
/// their own between bare sentences. Empty: too few lines to tell.
std::optional<SentenceFront> front_of_sentences(wire::Bytes text);

/// The kind of a DVL's lines if nearly all have a time in front of them. Empty: they have none.
std::optional<TextLine> lines_behind_times(wire::Bytes text);

/// True for the line of a logger that is a time alone.
bool is_time_alone(std::string_view line);

/// True if the stamps in front of the lines are the pauses between them, as `ts -i` prints them:
/// times of day below a minute, of which every fourth goes back.
bool are_pauses(wire::Bytes text);

/// Of the first begin of such a line in the text; the text's size: there is none.
std::size_t begin_in(std::string_view text, TextLine kind);

/// True for a stamp of what the computer sent, as Docklight marks it.
inline bool is_of_sent(std::string_view stamp) { return stamp.find("[TX]") != stamp.npos; }

}  // namespace drydock::capture
