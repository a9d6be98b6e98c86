#include <array>

#include "drivers/wire/dvl/water_linked.hpp"
#include "drivers/wire/text_fields.hpp"

/// Decodes valid frames to messages. water_linked.cpp finds the frames.
namespace drydock::wire {
namespace {

using namespace water_linked;

constexpr std::size_t head_size = 3;

/// Name and fields of a valid frame, without checksum and line end.
std::string_view body_of(Bytes frame) {
  std::string_view text = as_text(frame);
  while (!text.empty() && (text.back() == '\r' || text.back() == '\n')) text.remove_suffix(1);
  return text.substr(0, text.rfind('*'));
}

std::optional<std::chrono::microseconds> microseconds(TextFields& fields) {
  const auto value = fields.number();
  if (!value || *value < 0 || *value > 9e15) return std::nullopt;
  return std::chrono::microseconds{static_cast<std::int64_t>(*value)};
}

std::optional<double> milliseconds(TextFields& fields) { return scaled(fields.number(), 1e-3); }

std::optional<double> not_negative(std::optional<double> value) {
  return value && *value >= 0 ? value : std::nullopt;
}

std::optional<bool> yes_or_no(std::string_view text) {
  if (text == "y") return true;
  if (text == "n") return false;
  return std::nullopt;
}

constexpr bool hot(std::optional<int> status) { return status && (*status & 1) != 0; }

void read_velocity(TextFields& fields, Report& m) {
  for (auto& component : m.velocity_mps) component = fields.number();
}

void read_validity(TextFields& fields, Report& m) {
  m.valid = fields.text() == "y";
  if (!m.valid) m.velocity_mps = {};
}

std::array<std::optional<double>, 9> read_covariance(TextFields& fields) {
  std::array<std::optional<double>, 9> covariance;
  TextFields entries{fields.text(), ';'};
  if (entries.remaining() != covariance.size()) return covariance;
  for (auto& entry : covariance) entry = entries.number();
  return covariance;
}

void read_times(TextFields& fields, ReportTimes& m) {
  m.validity = microseconds(fields);
  m.transmission = microseconds(fields);
  m.interval_s = milliseconds(fields);
  m.hot = hot(fields.integer());
}

std::optional<WaterLinked::Message> read_bottom_velocity(TextFields fields) {
  if (fields.remaining() != 11) return std::nullopt;
  BottomVelocity m;
  read_velocity(fields, m);
  read_validity(fields, m);
  const auto altitude = fields.number();
  if (m.valid) m.altitude_m = not_negative(altitude);
  m.figure_of_merit_mps = fields.number();
  m.covariance = read_covariance(fields);
  read_times(fields, m);
  return m;
}

std::optional<WaterLinked::Message> read_water_velocity(TextFields fields) {
  if (fields.remaining() != 10) return std::nullopt;
  WaterVelocity m;
  read_velocity(fields, m);
  read_validity(fields, m);
  m.figure_of_merit_mps = fields.number();
  m.covariance = read_covariance(fields);
  read_times(fields, m);
  return m;
}

std::optional<WaterLinked::Message> read_old_velocity(TextFields fields) {
  if (fields.remaining() != 7 && fields.remaining() != 8) return std::nullopt;
  OldVelocity m;
  m.interval_s = milliseconds(fields);
  read_velocity(fields, m);
  m.figure_of_merit_mps = fields.number();
  m.altitude_m = not_negative(fields.number());
  read_validity(fields, m);
  if (!m.valid) m.altitude_m.reset();
  if (const auto status = fields.integer()) m.hot = hot(status);
  return m;
}

std::optional<WaterLinked::Message> read_transducer(TextFields fields) {
  if (fields.remaining() != 5) return std::nullopt;
  Transducer m;
  const auto id = fields.integer();
  if (!id) return std::nullopt;
  m.id = *id;
  m.velocity_mps = fields.number();
  m.distance_m = not_negative(fields.number());
  if (!m.distance_m) m.velocity_mps.reset();
  m.rssi_dbm = fields.number();
  m.noise_dbm = fields.number();
  return m;
}

std::optional<WaterLinked::Message> read_old_ranges(TextFields fields) {
  if (fields.remaining() != 4) return std::nullopt;
  OldRanges m;
  for (auto& distance : m.distance_m) distance = not_negative(fields.number());
  return m;
}

std::optional<WaterLinked::Message> read_dead_reckoning(TextFields fields) {
  if (fields.remaining() != 9) return std::nullopt;
  DeadReckoning m;
  m.time_s = fields.number();
  for (auto& component : m.position_m) component = fields.number();
  m.position_deviation_m = fields.number();
  m.roll_rad = fields.angle();
  m.pitch_rad = fields.angle();
  m.yaw_rad = fields.angle();
  m.trouble = fields.integer().value_or(0) != 0;
  return m;
}

std::optional<WaterLinked::Message> read_version(TextFields fields) {
  const auto major = fields.integer(), minor = fields.integer(), patch = fields.integer();
  if (!major || !minor || !patch) return std::nullopt;
  return Version{*major, *minor, *patch};
}

std::optional<WaterLinked::Message> read_product(TextFields fields) {
  if (fields.remaining() < 3) return std::nullopt;
  Product m;
  m.name = fields.text();
  m.version = fields.text();
  m.chip_id = fields.text();
  m.ip_address = fields.text();
  return m;
}

std::optional<WaterLinked::Message> read_response(char name, std::string_view options) {
  const TextFields fields{options};
  switch (name) {
    case 'z': return read_bottom_velocity(fields);
    case 's': return read_water_velocity(fields);
    case 'x': return read_old_velocity(fields);
    case 'u': return read_transducer(fields);
    case 't': return read_old_ranges(fields);
    case 'p': return read_dead_reckoning(fields);
    case 'v': return read_version(fields);
    case 'w': return read_product(fields);
    case 'c':
      if (const auto configuration = read_configuration(options)) return *configuration;
      return std::nullopt;
    case 'a': return Answer{Verdict::done};
    case 'n': return Answer{Verdict::refused};
    case '?': return Answer{Verdict::not_understood};
    case '!': return Answer{Verdict::bad_checksum};
    default: return std::nullopt;
  }
}

}  // namespace

std::optional<WaterLinked::Message> WaterLinked::decode(Bytes frame) {
  const std::string_view body = body_of(frame);
  if (body.size() < head_size) return std::nullopt;
  const std::string_view options = body.substr(std::min(head_size + 1, body.size()));
  if (body[1] == 'c') return Command{body[2], options};
  return read_response(body[2], options);
}

namespace water_linked {

std::optional<Configuration> read_configuration(std::string_view options) {
  TextFields fields{options};
  const std::size_t count = fields.remaining();
  if (count < 4 || count > 6) return std::nullopt;
  Configuration m;
  bool sound = true;
  const auto read = [&](auto parse) {
    const std::string_view field = fields.text();
    const auto value = parse(field);
    sound &= field.empty() || value.has_value();
    return value;
  };
  m.sound_speed_mps = read(parse_number);
  if (const auto rotation_deg = read(parse_number))
    m.mounting_rotation_rad = radians(*rotation_deg);
  m.acoustic_enabled = read(yes_or_no);
  m.dark_mode = read(yes_or_no);
  m.range_mode = fields.text();
  m.periodic_cycling = read(yes_or_no);
  return sound ? std::optional{m} : std::nullopt;
}

std::string_view to_string(Verdict verdict) {
  constexpr std::array<std::string_view, 4> names{"done", "refused", "not_understood",
                                                  "bad_checksum"};
  return names[static_cast<std::size_t>(verdict)];
}

}  // namespace water_linked
}  // namespace drydock::wire
