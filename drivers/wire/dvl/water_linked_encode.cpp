#include <algorithm>

#include "drivers/wire/dvl/water_linked.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire::water_linked {
namespace {

/// Writes one sentence. A missing number is written as the value that means "none".
class Line {
 public:
  Line(std::span<std::uint8_t> out, std::string_view head) : out_(out) { out_.text(head); }

  void text(std::string_view field) {
    out_.text(",");
    out_.text(field);
  }
  void number(double value, int decimals) {
    out_.text(",");
    out_.number(value, decimals);
  }
  void number(const std::optional<double>& value, int decimals, double none) {
    number(value.value_or(none), decimals);
  }
  void time(const std::optional<std::chrono::microseconds>& time) {
    number(static_cast<double>(time.value_or(std::chrono::microseconds{0}).count()), 0);
  }
  void number_or_blank(const std::optional<double>& value, int decimals) {
    if (value) return number(*value, decimals);
    text("");
  }
  void letter(const std::optional<bool>& yes) { text(yes ? (*yes ? "y" : "n") : ""); }

  void covariance(const std::array<std::optional<double>, 9>& entries) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      out_.text(i == 0 ? "," : ";");
      out_.number(entries[i].value_or(0), 9);
    }
  }

  std::size_t finish() {
    constexpr std::string_view digits = "0123456789abcdef";
    const std::uint8_t crc = crc8(as_text(out_.written()));
    const std::array<char, 5> tail{'*', digits[crc >> 4], digits[crc & 15], '\r', '\n'};
    out_.text({tail.data(), tail.size()});
    return out_.size();
  }

 private:
  FieldWriter out_;
};

void write_velocity(Line& line, const Report& m) {
  for (const auto& component : m.velocity_mps) line.number(component, 3, 0);
}

constexpr double no_distance = -1;

}  // namespace

std::size_t encode(const BottomVelocity& m, std::span<std::uint8_t> out) {
  Line line{out, "wrz"};
  write_velocity(line, m);
  line.letter(m.valid);
  line.number(m.altitude_m, 2, no_distance);
  line.number(m.figure_of_merit_mps, 3, 0);
  line.covariance(m.covariance);
  line.time(m.validity);
  line.time(m.transmission);
  line.number(scaled(m.interval_s, 1e3), 2, 0);
  line.text(m.hot ? "1" : "0");
  return line.finish();
}

std::size_t encode(const OldVelocity& m, std::span<std::uint8_t> out) {
  Line line{out, "wrx"};
  line.number(scaled(m.interval_s, 1e3), 2, 0);
  write_velocity(line, m);
  line.number(m.figure_of_merit_mps, 3, 0);
  line.number(m.altitude_m, 2, no_distance);
  line.letter(m.valid);
  if (m.hot) line.text(*m.hot ? "1" : "0");
  return line.finish();
}

std::size_t encode(const Transducer& m, std::span<std::uint8_t> out) {
  Line line{out, "wru"};
  line.number(m.id, 0);
  line.number(m.velocity_mps, 3, 0);
  line.number(m.distance_m, 2, no_distance);
  line.number(m.rssi_dbm, 0, 0);
  line.number(m.noise_dbm, 0, 0);
  return line.finish();
}

std::size_t encode(const OldRanges& m, std::span<std::uint8_t> out) {
  Line line{out, "wrt"};
  for (const auto& distance : m.distance_m) line.number(distance, 2, no_distance);
  return line.finish();
}

std::size_t encode(const Version& m, std::span<std::uint8_t> out) {
  Line line{out, "wrv"};
  for (const int number : {m.major, m.minor, m.patch}) line.number(number, 0);
  return line.finish();
}

std::size_t encode(const Product& m, std::span<std::uint8_t> out) {
  Line line{out, "wrw"};
  line.text(m.name);
  line.text(m.version);
  line.text(m.chip_id);
  if (!m.ip_address.empty()) line.text(m.ip_address);
  return line.finish();
}

std::size_t encode(const Configuration& m, std::span<std::uint8_t> out) {
  Line line{out, "wrc"};
  line.number(m.sound_speed_mps, 2, 0);
  line.number(degrees(m.mounting_rotation_rad), 2, 0);
  line.letter(m.acoustic_enabled);
  line.letter(m.dark_mode);
  line.text(m.range_mode);
  line.letter(m.periodic_cycling);
  return line.finish();
}

std::size_t encode(const Answer& m, std::span<std::uint8_t> out) {
  constexpr std::array<std::string_view, 4> names{"wra", "wrn", "wr?", "wr!"};
  return Line{out, names[static_cast<std::size_t>(m.verdict)]}.finish();
}

std::size_t encode(const Command& m, std::span<std::uint8_t> out) {
  const std::array<char, 3> head{'w', 'c', m.letter};
  Line line{out, {head.data(), head.size()}};
  if (!m.options.empty()) line.text(m.options);
  return line.finish();
}

std::size_t encode_settings(const Configuration& m, std::span<std::uint8_t> out) {
  Line line{out, "wcs"};
  line.number_or_blank(m.sound_speed_mps, 2);
  line.number_or_blank(degrees(m.mounting_rotation_rad), 2);
  line.letter(m.acoustic_enabled);
  line.letter(m.dark_mode);
  line.text(m.range_mode);
  line.letter(m.periodic_cycling);
  return line.finish();
}

}  // namespace drydock::wire::water_linked
