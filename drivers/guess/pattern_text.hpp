#pragma once

#include <cstddef>
#include <string>
#include <string_view>

/// Texts of lines as a description writes them.
namespace drydock::guess {

/// What a description takes: rig_config/schema/device.schema.json.
inline constexpr std::size_t longest_head = 32, longest_pattern = 512;

/// A letter that is not of ASCII, such as a degree sign, or a byte of one.
constexpr bool is_foreign(char c) { return static_cast<unsigned char>(c) >= 0x80; }

/// Text as RE2 takes it literally, inside a literal string of TOML, which has no apostrophe.
/// Letters that are not of ASCII may be any, and may be left out.
std::string regex_of(std::string_view text);

/// In a basic string of TOML.
std::string escaped(std::string_view text);

/// For `emulate`: a bracket that begins no group.
std::string with_double_brackets(std::string_view text);

}  // namespace drydock::guess
