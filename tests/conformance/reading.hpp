#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/device/driver_options.hpp"
#include "drivers/measurement/measurement.hpp"
#include "drivers/wire/codec.hpp"

/// Reads captures with drydock's own code, and references as JSON.
namespace drydock::conformance {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double degree = 180 / std::numbers::pi;  ///< degrees per radian

/// The output of `drydock decode` for a capture.
struct Decoded {
  std::vector<json> messages;
  std::uint64_t frames = 0, bad_checksums = 0;  ///< from the line of totals
};
Decoded decode(std::string_view protocol, const fs::path& capture);
Decoded decode_bytes(std::string_view protocol, std::string_view bytes);

/// The measurements that the driver of a sensor on a byte link publishes for these bytes. They come
/// in blocks, as from a port.
std::vector<measurement::Measurement> drive(device::Kind kind, std::string_view protocol,
                                            std::string_view bytes);

template <class M>
std::vector<M> all_of(const std::vector<measurement::Measurement>& heard) {
  std::vector<M> found;
  for (const auto& one : heard)
    if (const M* m = std::get_if<M>(&one)) found.push_back(*m);
  return found;
}

/// These throw Unreadable.
std::string read_text(const fs::path& file);
std::vector<json> read_json_lines(const fs::path& file);

std::vector<std::string> lines_of(std::string_view text);
std::vector<std::string> split(std::string_view text, char separator);
wire::Bytes as_bytes(std::string_view text);

/// Converts a value of a struct of optionals to JSON.
template <class T>
json optional(const std::optional<T>& value) {
  return value ? json(*value) : json();
}

}  // namespace drydock::conformance
