#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dvl/ad2cp_read.hpp"

/// Record 17. Which values are valid and which groups are there stands in the configuration.
namespace drydock::wire::ad2cp {
namespace {

constexpr std::size_t fixed_part = 78;
constexpr std::uint16_t no_merit = 0xFFFF;
constexpr double pa_per_mdbar = 10;

enum ConfigurationBit : unsigned {
  has_pressure = 1U << 0,
  has_temperature = 1U << 1,
  has_compass = 1U << 2,
  has_tilt = 1U << 3,
  has_velocity = 1U << 5,
  has_distance = 1U << 8,
  has_merit = 1U << 9,
};

double centidegrees(int raw) { return radians(raw / 100.0); }

void read_sensors(Bytes data, unsigned configuration, SignatureBottomTrack& m) {
  if (const auto decimetres = load_le<std::uint16_t>(data, 16))
    m.sound_speed_mps = decimetres / 10.0;
  if ((configuration & has_temperature) != 0)
    m.temperature_k = load_le<std::int16_t>(data, 18) / 100.0 + zero_celsius_k;
  if ((configuration & has_pressure) != 0)
    m.pressure_pa = load_le<std::uint32_t>(data, 20) * pa_per_mdbar;
  if ((configuration & has_compass) != 0)
    m.heading_rad = centidegrees(load_le<std::uint16_t>(data, 24));
  if ((configuration & has_tilt) == 0) return;
  m.pitch_rad = centidegrees(load_le<std::int16_t>(data, 26));
  m.roll_rad = centidegrees(load_le<std::int16_t>(data, 28));
}

void read_state(Bytes data, SignatureBottomTrack& m) {
  m.version = data[0];
  m.serial_number = load_le<std::uint32_t>(data, 4);
  m.clock = read_clock(data.subspan(8));
  const unsigned layout = load_le<std::uint16_t>(data, 30);
  m.axes = static_cast<Axes>(layout >> 10 & 3);
  m.number_of_beams = layout >> 12;
  m.battery_v = load_le<std::uint16_t>(data, 38) / 10.0;
  m.error = load_le<std::uint32_t>(data, 66);
  m.status = load_le<std::uint32_t>(data, 70);
  m.ensemble = load_le<std::uint32_t>(data, 74);
}

/// Takes the next group of one value for each beam, if it is there.
class Groups {
 public:
  Groups(Bytes rest, unsigned configuration, std::size_t beams)
      : rest_(rest), configuration_(configuration), beams_(beams) {}

  template <class Raw, class Take>
  bool each(ConfigurationBit present, Take&& take) {
    if ((configuration_ & present) == 0) return true;
    if (rest_.size() < beams_ * sizeof(Raw)) return false;
    for (std::size_t i = 0; i < beams_; ++i) take(i, load_le<Raw>(rest_, i * sizeof(Raw)));
    rest_ = rest_.subspan(beams_ * sizeof(Raw));
    return true;
  }
  unsigned configuration() const { return configuration_; }

 private:
  Bytes rest_;
  unsigned configuration_;
  std::size_t beams_;
};

/// Without a bottom the velocity is the ambiguity velocity; only the other two groups tell it.
void forget_beams_without_bottom(unsigned configuration, SignatureBottomTrack& m) {
  for (std::size_t i = 0; i < 4; ++i) {
    const bool far = (configuration & has_distance) != 0 && !m.distance_m[i];
    const bool vague = (configuration & has_merit) != 0 && !m.figure_of_merit[i];
    if (!far && !vague) continue;
    m.velocity_mps[i].reset();
    m.distance_m[i].reset();
    m.figure_of_merit[i].reset();
  }
}

bool read_beams(Groups groups, double velocity_step_mps, SignatureBottomTrack& m) {
  const auto velocity = [&](std::size_t i, int raw) {
    m.velocity_mps[i] = raw * velocity_step_mps;
  };
  const auto distance = [&](std::size_t i, int mm) {
    if (mm > 0) m.distance_m[i] = mm / 1000.0;
  };
  const auto merit = [&](std::size_t i, unsigned raw) {
    if (raw != no_merit) m.figure_of_merit[i] = raw;
  };
  const bool whole = groups.each<std::int32_t>(has_velocity, velocity) &&
                     groups.each<std::int32_t>(has_distance, distance) &&
                     groups.each<std::uint16_t>(has_merit, merit);
  forget_beams_without_bottom(groups.configuration(), m);
  return whole;
}

}  // namespace

bool read(Bytes data, SignatureBottomTrack& m) {
  if (data.size() < fixed_part || data[1] < fixed_part || data.size() < data[1]) return false;
  const unsigned configuration = load_le<std::uint16_t>(data, 2);
  read_state(data, m);
  if (m.number_of_beams > 4) return false;
  read_sensors(data, configuration, m);
  const double step_mps = std::pow(10.0, static_cast<std::int8_t>(data[60]));
  m.ambiguity_velocity_mps = load_le<std::uint32_t>(data, 52) * step_mps;
  return read_beams({data.subspan(data[1]), configuration, m.number_of_beams}, step_mps, m);
}

}  // namespace drydock::wire::ad2cp
