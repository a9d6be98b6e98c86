#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace drydock::terminal {

/// Bytes of `512MiB`, `20GB` or `1.5TiB`. Empty for any other text, without a unit, and for sizes
/// below a byte or above 8 EiB.
std::optional<std::uint64_t> parse_data_size(std::string_view text);
std::string no_data_size(std::string_view text);  ///< the error line for a text that is no size

/// "842 B", "12 kB", "3.4 MB", "1.2 GB": SI units, MB and GB with one decimal.
std::string data_size_text(std::uint64_t bytes);

}  // namespace drydock::terminal
