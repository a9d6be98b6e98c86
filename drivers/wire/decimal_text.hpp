#pragma once

/// Numbers as text, for the many that a device writes: the same characters as std::to_chars, in a
/// fraction of its time. A double times a power of ten is a whole number of 128 bits over a power
/// of two, so the digits are exact and rounded to even as there.
namespace drydock::wire {

/// Room for either text.
inline constexpr int decimal_text_size = 64;

/// `value` with so many decimals, as of std::chars_format::fixed. Returns the end; null: there is
/// no room.
char* fixed_text(double value, int decimals, char* out);

/// `value` with 9 significant digits, without zeros at the end, as of std::chars_format::general.
char* general_text(double value, char* out);

}  // namespace drydock::wire
