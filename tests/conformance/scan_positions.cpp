#include "tests/conformance/scan_positions.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "tests/conformance/reading.hpp"
#include "tests/conformance/scan.hpp"

namespace drydock::conformance {

namespace {

constexpr double position_step_deg = 1e-7;

/// Columns of a sentence: time, latitude (its hemisphere, longitude and hemisphere follow), and the
/// column for validity with the letters that mean valid.
struct Columns {
  std::string_view formatter;
  std::size_t time, latitude, vouch;
  std::string_view vouching;
};
constexpr std::array sentences{
    Columns{"GGA", 1, 2, 6, "123456"},
    Columns{"RMC", 1, 3, 2, "A"},
    Columns{"GNS", 1, 2, 6, "ADPRFE"},
    Columns{"GLL", 5, 1, 6, "A"},
};

/// ddmm.mmmm and a hemisphere. South and west are negative.
std::optional<double> angle_deg(std::string_view text, std::string_view hemisphere) {
  double sent = 0;
  const auto end = std::from_chars(text.data(), text.data() + text.size(), sent).ptr;
  if (text.empty() || end != text.data() + text.size() || hemisphere.empty()) return {};
  const double degrees = std::floor(sent / 100);
  const double angle = degrees + (sent - 100 * degrees) / 60;
  return hemisphere == "S" || hemisphere == "W" ? -angle : angle;
}

/// A number of satellites: 0 or 00.
bool is_zero(std::string_view field) {
  return !field.empty() && field.find_first_not_of('0') == field.npos;
}

std::optional<WirePosition> read_sentence(std::string_view sentence) {
  const auto fields = split(sentence, ',');
  for (const Columns& c : sentences) {
    if (fields[0].size() != 6 || !fields[0].ends_with(c.formatter)) continue;
    if (fields.size() <= std::max(c.vouch, c.latitude + 3)) return {};
    const auto latitude = angle_deg(fields[c.latitude], fields[c.latitude + 1]);
    const auto longitude = angle_deg(fields[c.latitude + 2], fields[c.latitude + 3]);
    if (!latitude || !longitude) return {};
    const bool vouched_for = fields[c.vouch].find_first_of(c.vouching) != std::string::npos;
    const bool by_none = c.formatter == "GGA" && fields.size() > 7 && is_zero(fields[7]);
    return WirePosition{{*latitude, *longitude}, fields[c.time], vouched_for, by_none};
  }
  return {};
}

/// A GSA without a fix. It has no time: its epoch is that of the sentence before or after it.
bool says_no_fix(std::string_view sentence) {
  const auto fields = split(sentence, ',');
  return fields.size() > 2 && fields[0].size() == 6 && fields[0].ends_with("GSA") &&
         fields[2] == "1";
}

std::int32_t signed_le(std::string_view bytes, std::size_t at) {
  return static_cast<std::int32_t>(pair_le(bytes, at) | pair_le(bytes, at + 2) << 16);
}

std::optional<WirePosition> read_pvt(std::string_view frame) {
  constexpr std::size_t payload = 6, shortest = 84;
  if (octet(frame, 2) != 1 || octet(frame, 3) != 0x07 || frame.size() < payload + shortest + 2)
    return {};
  constexpr unsigned dead_reckoning = 1, gnss_with_dead_reckoning = 4;  // 5: time only
  const unsigned fix = octet(frame, payload + 20);
  return WirePosition{{signed_le(frame, payload + 28) * position_step_deg,
                       signed_le(frame, payload + 24) * position_step_deg},
                      "iTOW " + std::to_string(signed_le(frame, payload)),
                      (octet(frame, payload + 21) & 1) != 0 && fix >= dead_reckoning &&
                          fix <= gnss_with_dead_reckoning};
}

}  // namespace

bool same_place(const Position& a, const Position& b) {
  constexpr double half_step = position_step_deg / 2;
  return std::abs(a.latitude_deg - b.latitude_deg) <= half_step &&
         std::abs(a.longitude_deg - b.longitude_deg) <= half_step;
}

std::vector<WirePosition> scan_positions(std::string_view bytes) {
  std::vector<WirePosition> found;
  const auto keep = [&](std::optional<WirePosition> position) {
    if (position) found.push_back(std::move(*position));
  };
  for (const std::string_view frame : scan_ubx(bytes)) keep(read_pvt(frame));
  bool doubted = false;
  for (const std::string_view sentence : scan_nmea(bytes)) {
    if (says_no_fix(sentence)) {
      if (!found.empty()) found.back().vouched_for = false;
      doubted = true;
    } else if (auto position = read_sentence(sentence)) {
      position->vouched_for = position->vouched_for && !doubted;
      doubted = false;
      found.push_back(*std::move(position));
    }
  }
  return found;
}

}  // namespace drydock::conformance
