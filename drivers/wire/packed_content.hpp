#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace drydock::wire {

/// So many first bytes tell it.
inline constexpr std::size_t longest_packed_magic = 5;

/// What to do with a file that a packing program made, by its first bytes; empty: none did.
inline std::string_view packed_content(std::string_view head) {
  struct Sign {
    std::string_view magic, advice;
  };
  constexpr std::array<Sign, 5> signs{{
      {"\x1F\x8B\x08", "it is compressed: unpack it first with gunzip -k"},
      {"\x28\xB5\x2F\xFD", "it is compressed: unpack it first with unzstd"},
      {"\xFD"
       "7zXZ",
       "it is compressed: unpack it first with unxz -k"},
      {"BZh", "it is compressed: unpack it first with bunzip2 -k"},
      {"PK\x03\x04", "it is an archive: unpack it first with unzip"},
  }};
  const auto* found =
      std::ranges::find_if(signs, [&](const Sign& sign) { return head.starts_with(sign.magic); });
  return found == signs.end() ? std::string_view() : found->advice;
}

}  // namespace drydock::wire
