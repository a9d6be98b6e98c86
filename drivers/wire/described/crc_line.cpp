#include "drivers/wire/described/crc_line.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>

#include "drivers/wire/described/checksums.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::described {
namespace {

std::optional<std::uint64_t> number(std::string_view text, int base) {
  if (base == 16 && (text.starts_with("0x") || text.starts_with("0X"))) text.remove_prefix(2);
  std::uint64_t value = 0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (text.empty() || error != std::errc{} || stop != text.data() + text.size()) return {};
  return value;
}

/// The parameters by their place in `words`.
struct Parameters {
  static constexpr std::array<std::string_view, 7> words{"width",  "poly",   "init", "refin",
                                                         "refout", "xorout", "check"};
  std::array<std::optional<std::uint64_t>, words.size()> values;

  /// Empty, or what is wrong with the word.
  std::string take(std::string_view word) {
    const std::size_t equals = std::min(word.find('='), word.size());
    const std::string_view key = word.substr(0, equals),
                           value = word.substr(std::min(equals + 1, word.size()));
    if (key == "name" || key == "residue") return {};
    for (std::size_t i = 0; i < words.size(); ++i) {
      if (words[i] != key) continue;
      if (key.starts_with("ref"))
        values[i] = value == "true"    ? std::optional<std::uint64_t>(1)
                    : value == "false" ? std::optional<std::uint64_t>(0)
                                       : std::nullopt;
      else
        values[i] = number(value, key == "width" ? 10 : 16);
      return values[i] ? std::string() : fmt::format("{} has no value in \"{}\"", key, word);
    }
    return fmt::format("\"{}\" is no parameter of a CRC, allowed: {}", key, fmt::join(words, ", "));
  }
};

}  // namespace

std::string read_crc(std::string_view line, Crc& into) {
  Parameters read;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find(' '), line.size());
    if (end > 0)
      if (auto fault = read.take(line.substr(0, end)); !fault.empty()) return fault;
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  const auto& [width, poly, init, refin, refout, xorout, check] = read.values;
  for (std::size_t i = 0; i + 1 < read.values.size(); ++i)
    if (!read.values[i]) return fmt::format("{}= is missing", Parameters::words[i]);
  if (*width != 8 && *width != 16 && *width != 24 && *width != 32)
    return "a CRC has 8, 16, 24 or 32 bits here";
  if (*refin != *refout) return "refin and refout must be the same";
  for (const auto& value : {poly, init, xorout})
    if (*value >> *width != 0) return fmt::format("{:X} has more than {} bits", *value, *width);
  constexpr std::array<std::string_view, 5> names{"", "a CRC of 8 bits", "a CRC of 16 bits",
                                                  "a CRC of 24 bits", "a CRC of 32 bits"};
  into = {.name = names[*width / 8],
          .width = static_cast<unsigned>(*width),
          .polynomial = static_cast<std::uint32_t>(*poly),
          .start = static_cast<std::uint32_t>(*init),
          .reflected = *refin != 0,
          .xor_out = static_cast<std::uint32_t>(*xorout),
          .check = static_cast<std::uint32_t>(check.value_or(0))};
  constexpr std::array<std::uint8_t, 9> digits{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  const std::uint32_t made = Checksum(into).of(digits);
  if (check && *check != made)
    return fmt::format("these parameters give {:X} for 123456789, not check={:X}", made, *check);
  return {};
}

}  // namespace drydock::wire::described
