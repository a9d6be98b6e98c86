#pragma once

#include "drivers/wire/pgn_table/content.hpp"

/// Texts of NMEA 2000. One of no characters has no content. Bytes that are no UTF-8 are read as
/// Latin-1.
namespace drydock::wire::pgn_table {

/// Padded with @, blanks, 0 or 255.
Extent read_fixed_text(const Slice& slice);
/// Length, characters. The table's text says that a 0 follows, which the length does not count;
/// canboat and canboatjs read none.
Extent read_text_with_length(const Slice& slice);
/// Length with its own byte and the next, kind (0 UTF-16, 1 UTF-8), characters.
Extent read_text_with_kind(const Slice& slice);
/// Two digits a byte, the first byte first; 255 is no digit.
Extent read_decimal(const Slice& slice);

}  // namespace drydock::wire::pgn_table
