#include "drivers/wire/dvl/nortek.hpp"

#include <cmath>

#include "drivers/wire/hex.hpp"
#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "drivers/wire/text_fields.hpp"

namespace drydock::wire {
namespace {

constexpr double bad_velocity = -32.768, bad_distance = 0, bad_merit = 10;

/// The values of a sentence, with or without names before them.
class NortekFields {
 public:
  explicit NortekFields(std::string_view text) : fields_(text) {}

  std::size_t remaining() const { return fields_.remaining(); }
  std::string_view text() {
    const std::string_view field = fields_.text();
    return field.substr(field.find('=') + 1);  // npos + 1 is 0
  }
  std::optional<double> number() { return parse_number(text()); }
  std::optional<double> milliseconds() { return scaled(number(), 1e-3); }
  std::optional<double> velocity() {
    const auto value = number();
    return value && *value > bad_velocity + 1e-6 ? value : std::nullopt;
  }
  std::optional<double> distance() {
    const auto value = number();
    return value && *value > bad_distance ? value : std::nullopt;
  }
  std::optional<double> merit() {
    const auto value = number();
    return value && std::abs(*value - bad_merit) > 1e-6 ? value : std::nullopt;
  }
  std::optional<unsigned> status() {
    const std::string_view field = text();
    return field.starts_with("0x") ? parse_hex(field.substr(2)) : std::nullopt;
  }

 private:
  TextFields fields_;
};

/// hhmmss.s, a time of day.
std::optional<std::chrono::nanoseconds> time_of_day(std::string_view text) {
  if (text.size() < 6) return std::nullopt;
  const auto hour = parse_integer(text.substr(0, 2)), minute = parse_integer(text.substr(2, 2));
  const auto second = parse_number(text.substr(4));
  const auto within = [](const auto& value, auto limit) {
    return value && *value >= 0 && *value < limit;
  };
  if (!within(hour, 24) || !within(minute, 60) || !within(second, 61.0)) return std::nullopt;
  return std::chrono::hours{*hour} + std::chrono::minutes{*minute} +
         std::chrono::nanoseconds{std::llround(*second * 1e9)};
}

void read_times(NortekFields& fields, NortekTimes& m) {
  m.after_trigger_s = fields.milliseconds();
  m.after_sentence_s = fields.milliseconds();
}

std::optional<Nortek::Message> read_beam(NortekFields fields) {
  if (fields.remaining() != 9) return std::nullopt;
  NortekBeam m;
  m.beam = parse_integer(fields.text());
  m.date = fields.text();
  m.time_of_day = time_of_day(fields.text());
  read_times(fields, m);
  m.velocity_mps = fields.velocity();
  m.figure_of_merit_mps = fields.merit();
  m.distance_m = fields.distance();
  m.status = fields.status();
  return m;
}

template <class Speed>
std::optional<Nortek::Message> read_speed(NortekFields fields) {
  if (fields.remaining() != 6) return std::nullopt;
  Speed m;
  read_times(fields, m);
  m.speed_mps = fields.velocity();
  if (const auto direction_deg = fields.number()) m.direction_rad = radians(*direction_deg);
  m.figure_of_merit_mps = fields.merit();
  m.distance_m = fields.distance();
  return m;
}

template <class Velocity>
std::optional<Nortek::Message> read_velocity(NortekFields fields) {
  const std::size_t count = fields.remaining();
  if (count != 11 && count != 16) return std::nullopt;
  Velocity m;
  m.ping_time_s = fields.number();
  read_times(fields, m);
  for (auto& component : m.velocity_mps) component = fields.velocity();
  m.figure_of_merit_mps = fields.merit();
  for (auto& distance : m.distance_m) distance = fields.distance();
  if (count == 11) return m;
  m.battery_v = fields.number();
  m.sound_speed_mps = fields.number();
  fields.text();  // pressure; public descriptions disagree on its unit
  if (const auto celsius = fields.number()) m.temperature_k = *celsius + zero_celsius_k;
  m.status = fields.status();
  return m;
}

}  // namespace

Scan Nortek::scan(Bytes bytes) { return Nmea0183::scan(bytes); }

std::optional<Nortek::Message> Nortek::decode(Bytes frame) {
  constexpr std::string_view address = "$PNORBT", water_address = "$PNORWT";
  const std::string_view line = as_text(frame);
  const std::string_view text = line.substr(0, line.rfind('*'));
  const bool water = text.starts_with(water_address);
  if (!water && !text.starts_with(address)) return std::nullopt;
  if (text.size() < address.size() + 2) return std::nullopt;
  if (text[address.size() + 1] != ',') return std::nullopt;
  const NortekFields fields{text.substr(address.size() + 2)};
  switch (text[address.size()]) {
    case '0':
    case '1': return water ? std::nullopt : read_beam(fields);
    case '3':
    case '4': return water ? read_speed<NortekWaterSpeed>(fields) : read_speed<NortekSpeed>(fields);
    case '6':
    case '7':
    case '8':
    case '9':
      return water ? read_velocity<NortekWaterVelocity>(fields)
                   : read_velocity<NortekVelocity>(fields);
    default: return std::nullopt;
  }
}

namespace {

std::size_t write_velocity(std::string_view address, const NortekVelocity& m,
                           std::span<std::uint8_t> out) {
  FieldWriter line{out};
  const auto number = [&](std::optional<double> value, int decimals) {
    line.text(",");
    if (value) line.number(*value, decimals);
  };
  const bool with_state = m.status.has_value();
  line.text(address);
  line.text(with_state ? "9" : "7");
  number(m.ping_time_s, 4);
  number(scaled(m.after_trigger_s, 1e3), 3);
  number(scaled(m.after_sentence_s, 1e3), 3);
  for (const auto& component : m.velocity_mps) number(component.value_or(bad_velocity), 4);
  number(m.figure_of_merit_mps.value_or(bad_merit), 4);
  for (const auto& distance : m.distance_m) number(distance.value_or(bad_distance), 2);
  if (with_state) {
    number(m.battery_v, 1);
    number(m.sound_speed_mps, 1);
    number(std::nullopt, 1);  // pressure
    number(m.temperature_k ? std::optional{*m.temperature_k - zero_celsius_k} : std::nullopt, 1);
    std::array<std::uint8_t, 8> digits;
    TextWriter hex{digits};
    hex.put_hex(*m.status, 8);
    line.text(",0x");
    line.text(as_text(digits));
  }
  std::uint8_t sum = 0;
  for (const char c : as_text(line.written()).substr(line.size() ? 1 : 0)) {
    sum = static_cast<std::uint8_t>(sum ^ c);
  }
  std::array<std::uint8_t, 2> digits;
  TextWriter hex{digits};
  hex.put_hex(sum, 2);
  line.text("*");
  line.text(as_text(digits));
  line.text("\r\n");
  return line.size();
}

}  // namespace

std::size_t encode(const NortekVelocity& m, std::span<std::uint8_t> out) {
  return write_velocity("$PNORBT", m, out);
}

std::size_t encode(const NortekWaterVelocity& m, std::span<std::uint8_t> out) {
  return write_velocity("$PNORWT", m, out);
}

}  // namespace drydock::wire
