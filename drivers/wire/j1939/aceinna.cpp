#include "drivers/wire/j1939/aceinna.hpp"

#include "drivers/wire/bit_field.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/can/frame_protocol.hpp"

namespace drydock::wire::aceinna {

namespace {

constexpr std::uint32_t magnetic_pgn = 65386;

// For each quantity: the zero point in steps, then steps per degree, degree per second, m/s2 or
// second.
constexpr double slope_zero = 250.0 * 32768, slope_steps = 32768;
constexpr double rate_zero = 250.0 * 128, rate_steps = 128;
constexpr double acceleration_zero = 320.0 * 100, acceleration_steps = 100;
constexpr double magnetic_zero = 8.0 * 4000, magnetic_steps = 4000;  // gauss
constexpr double tesla_per_gauss = 1e-4;
constexpr double latency_steps = 2000;

std::uint32_t load_u24(Bytes bytes, std::size_t offset) {
  return load_le<std::uint16_t>(bytes, offset) | std::uint32_t{bytes[offset + 2]} << 16;
}

void store_u24(std::span<std::uint8_t> bytes, std::size_t offset, std::uint32_t value) {
  store_le<std::uint16_t>(bytes, offset, value & 0xFFFF);
  bytes[offset + 2] = value >> 16 & 0xFF;
}

std::uint8_t two_bits(std::uint8_t byte, unsigned at) { return byte >> at & 3; }

FigureOfMerit merit_of(std::uint8_t byte, unsigned at) {
  return static_cast<FigureOfMerit>(two_bits(byte, at));
}

/// The value if the device calls it valid, otherwise empty.
std::optional<double> vouched(std::optional<double> value, FigureOfMerit merit) {
  const bool vouches = merit == FigureOfMerit::ok || merit == FigureOfMerit::degraded;
  return vouches ? value : std::nullopt;
}

std::optional<double> to_radians(std::optional<double> angle_deg) {
  if (!angle_deg) return std::nullopt;
  return radians(*angle_deg);
}

std::optional<double> latency_of(std::uint8_t raw) { return j1939_field<8>(raw, 0, latency_steps); }

std::uint8_t to_latency(const std::optional<double>& latency_s) {
  return static_cast<std::uint8_t>(to_j1939_field<8>(latency_s, 0, latency_steps));
}

std::uint8_t pack(std::uint8_t a, std::uint8_t b, std::uint8_t c, std::uint8_t d) {
  return static_cast<std::uint8_t>((a & 3) | (b & 3) << 2 | (c & 3) << 4 | (d & 3) << 6);
}

std::uint8_t code(FigureOfMerit merit) { return static_cast<std::uint8_t>(merit); }

SlopeSensor decode_slope(std::uint8_t source, Bytes p) {
  SlopeSensor m;
  m.source = source;
  m.pitch_compensation = two_bits(p[6], 0);
  m.pitch_merit = merit_of(p[6], 2);
  m.roll_compensation = two_bits(p[6], 4);
  m.roll_merit = merit_of(p[6], 6);
  const auto angle = [&](std::size_t offset, FigureOfMerit merit) {
    const auto deg = j1939_field<24>(load_u24(p, offset), slope_zero, slope_steps);
    return vouched(to_radians(deg), merit);
  };
  m.pitch_rad = angle(0, m.pitch_merit);
  m.roll_rad = angle(3, m.roll_merit);
  m.latency_s = latency_of(p[7]);
  return m;
}

AngularRate decode_rate(std::uint8_t source, Bytes p) {
  AngularRate m;
  m.source = source;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto raw = load_le<std::uint16_t>(p, 2 * axis);
    m.merit[axis] = merit_of(p[6], 2 * axis);
    m.rate_radps[axis] =
        vouched(to_radians(j1939_field<16>(raw, rate_zero, rate_steps)), m.merit[axis]);
  }
  m.latency_s = latency_of(p[7]);
  return m;
}

Acceleration decode_acceleration(std::uint8_t source, Bytes p) {
  Acceleration m;
  m.source = source;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto raw = load_le<std::uint16_t>(p, 2 * axis);
    m.merit[axis] = merit_of(p[6], 2 * axis);
    m.acceleration_mps2[axis] =
        vouched(j1939_field<16>(raw, acceleration_zero, acceleration_steps), m.merit[axis]);
  }
  m.rate_support = two_bits(p[6], 6);
  return m;
}

MagneticField decode_magnetic(std::uint8_t source, Bytes p) {
  MagneticField m;
  m.source = source;
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto gauss =
        j1939_field<16>(load_le<std::uint16_t>(p, 2 * axis), magnetic_zero, magnetic_steps);
    m.field_t[axis] = scaled(gauss, tesla_per_gauss);
  }
  return m;
}

template <class M>
std::optional<Aceinna::Message> read_as(const j1939::Identifier& id, Bytes payload) {
  M m;
  return read(id.source, payload, m) ? std::optional<Aceinna::Message>{m} : std::nullopt;
}

std::optional<Aceinna::Message> decode(const j1939::Identifier& id, Bytes payload) {
  switch (id.pgn) {
    case j1939::request_pgn: return j1939::decode_request(id, payload);
    case hardware_bit_pgn: return read_as<HardwareBit>(id, payload);
    case software_bit_pgn: return read_as<SoftwareBit>(id, payload);
    case status_pgn: return read_as<SensorStatus>(id, payload);
    case packet_rate_pgn: return read_as<PacketRate>(id, payload);
    case packet_type_pgn: return read_as<PacketType>(id, payload);
    case filter_pgn: return read_as<DigitalFilter>(id, payload);
    case orientation_pgn: return read_as<Orientation>(id, payload);
    default: break;
  }
  if (payload.size() < 8) return std::nullopt;
  switch (id.pgn) {
    case magnetic_pgn: return decode_magnetic(id.source, payload);
    case slope_pgn: return decode_slope(id.source, payload);
    case rate_pgn: return decode_rate(id.source, payload);
    case acceleration_pgn: return decode_acceleration(id.source, payload);
    default: return AddressClaimed{id.source, to_name(load_le<std::uint64_t>(payload, 0))};
  }
}

bool is_ours(std::uint32_t pgn) {
  return pgn == slope_pgn || pgn == rate_pgn || pgn == acceleration_pgn || pgn == magnetic_pgn ||
         (pgn >= hardware_bit_pgn && pgn <= orientation_pgn) || pgn == j1939::address_claim_pgn ||
         pgn == j1939::request_pgn;
}

}  // namespace

CanFrame encode(const SlopeSensor& m) {
  CanFrame frame = j1939::blank_frame({3, slope_pgn, j1939::global_address, m.source});
  store_u24(frame.data, 0, to_j1939_field<24>(degrees(m.pitch_rad), slope_zero, slope_steps));
  store_u24(frame.data, 3, to_j1939_field<24>(degrees(m.roll_rad), slope_zero, slope_steps));
  frame.data[6] =
      pack(m.pitch_compensation, code(m.pitch_merit), m.roll_compensation, code(m.roll_merit));
  frame.data[7] = to_latency(m.latency_s);
  return frame;
}

CanFrame encode(const AngularRate& m) {
  CanFrame frame = j1939::blank_frame({3, rate_pgn, j1939::global_address, m.source});
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto raw = to_j1939_field<16>(degrees(m.rate_radps[axis]), rate_zero, rate_steps);
    store_le<std::uint16_t>(frame.data, 2 * axis, raw);
  }
  frame.data[6] = pack(code(m.merit[0]), code(m.merit[1]), code(m.merit[2]), 0);
  frame.data[7] = to_latency(m.latency_s);
  return frame;
}

CanFrame encode(const Acceleration& m) {
  CanFrame frame = j1939::blank_frame({2, acceleration_pgn, j1939::global_address, m.source});
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto raw =
        to_j1939_field<16>(m.acceleration_mps2[axis], acceleration_zero, acceleration_steps);
    store_le<std::uint16_t>(frame.data, 2 * axis, raw);
  }
  frame.data[6] = pack(code(m.merit[0]), code(m.merit[1]), code(m.merit[2]), m.rate_support);
  return frame;
}

CanFrame encode(const MagneticField& m) {
  CanFrame frame = j1939::blank_frame({6, magnetic_pgn, j1939::global_address, m.source});
  for (unsigned axis = 0; axis < 3; ++axis) {
    const auto gauss = scaled(m.field_t[axis], 1 / tesla_per_gauss);
    store_le<std::uint16_t>(frame.data, 2 * axis,
                            to_j1939_field<16>(gauss, magnetic_zero, magnetic_steps));
  }
  return frame;
}

CanFrame encode(const AddressClaimed& m) {
  return j1939::encode(j1939::AddressClaimed{m.source, aceinna::to_value(m.name)});
}

// The fields run from the lowest bit upwards, in the order in which SAE's run from the highest bit
// downwards.
std::uint64_t to_value(const j1939::Name& n) {
  return std::uint64_t{n.arbitrary_address_capable} | std::uint64_t{n.industry_group & 0x7u} << 1 |
         std::uint64_t{n.vehicle_system_instance & 0xFu} << 4 |
         std::uint64_t{n.vehicle_system & 0x7Fu} << 8 | std::uint64_t{n.function} << 16 |
         std::uint64_t{n.function_instance & 0x1Fu} << 24 |
         std::uint64_t{n.ecu_instance & 0x7u} << 29 |
         std::uint64_t{n.manufacturer_code & 0x7FFu} << 32 |
         std::uint64_t{n.identity_number & 0x1FFFFF} << 43;
}

j1939::Name to_name(std::uint64_t value) {
  j1939::Name n;
  n.arbitrary_address_capable = (value & 1) != 0;
  n.industry_group = value >> 1 & 0x7;
  n.vehicle_system_instance = value >> 4 & 0xF;
  n.vehicle_system = value >> 8 & 0x7F;
  n.function = value >> 16 & 0xFF;
  n.function_instance = value >> 24 & 0x1F;
  n.ecu_instance = value >> 29 & 0x7;
  n.manufacturer_code = value >> 32 & 0x7FF;
  n.identity_number = static_cast<std::uint32_t>(value >> 43);
  return n;
}

}  // namespace drydock::wire::aceinna

namespace drydock::wire {

std::optional<Aceinna::Message> Aceinna::Decoder::receive(const CanFrame& frame) {
  const auto id = j1939::identify(frame);
  if (!id || !aceinna::is_ours(id->pgn)) return std::nullopt;
  return count_frame(counters_, frame, aceinna::decode(*id, frame.payload()));
}

}  // namespace drydock::wire
