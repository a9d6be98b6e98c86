#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

/// Lines of text that sensors send, by what they begin with.
namespace drydock::capture {

enum class TextLine : std::uint8_t { sentence, water_linked, pd6, json };

/// Characters of the begin of such a line with which the text ends; 0: it ends with none. They are
/// `$` or `!`, `wrx,`, `:SA,` and `{"`.
std::size_t begin_behind(std::string_view text, TextLine kind);

/// True if such a line may be whole, of which the begin was found. A mark of the logger may stand
/// behind a checksum.
bool is_whole(std::string_view line, TextLine kind);

/// True if `*hh` ends such a line.
bool has_checksum(TextLine kind);

}  // namespace drydock::capture
