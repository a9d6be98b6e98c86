#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/canopen/cia404_imu.hpp"

/// Epson's CANopen IMUs (M-G550PC2, M-G552PC1 and PC7): CiA 404 with 16-bit integer process values.
/// TPDO1 = counter, gyro X, Y, Z; TPDO2 = counter, accelerometer X, Y, Z; TPDO3 = counter,
/// temperature, and for the G552 reserved and status; TPDO4 = counter, time of the device's clock;
/// little-endian. PDOs with equal counters are one sample. Mapping and steps: object dictionaries,
/// data sheets (.eds) and README of Epson's own evaluation tool.
namespace drydock::wire::epson {

/// Properties that the frames do not show. Therefore each model is a separate protocol.
struct Model {
  double rate_radps, force_mps2;  ///< one step of the integers
  bool has_status;                ///< TPDO3 has a status behind the temperature
  bool day_first;                 ///< order of TPDO4's two parts
};

/// 0.008 deg/s and 0.2 mg, stated in Epson's tool. The values that it prints for a G550 are
/// multiples of them.
constexpr Model g550{.rate_radps = radians(0.008),
                     .force_mps2 = 0.2e-3 * units::standard_gravity,
                     .has_status = false,
                     .day_first = true};
/// 0.01515 deg/s and 0.4 mg, stated in the G552's object dictionary.
constexpr Model g552{.rate_radps = radians(0.01515),
                     .force_mps2 = 0.4e-3 * units::standard_gravity,
                     .has_status = true,
                     .day_first = false};

/// TPDO1 and TPDO2 with one counter, along the sensor's own axes.
struct Sample {
  std::uint8_t node = 0;
  std::uint16_t counter = 0;
  std::array<double, 3> rate_radps{}, specific_force_mps2{};
};

/// TPDO3: 8 bytes with a status, otherwise 4.
struct Condition {
  static constexpr std::string_view type = "condition";
  std::uint8_t node = 0;
  std::uint16_t counter = 0;
  double temperature_k = 0;
  std::optional<std::uint16_t> status;  ///< bits defined by the maker
};

/// TPDO4: the reading of the device's clock at the sample. CANopen's TIME message sets this clock.
/// Object 2101h:2, and therefore its PDO, has the milliseconds in bits 31 to 4 (CiA 301 has them in
/// 27 to 0).
struct DeviceTime {
  static constexpr std::string_view type = "device_time";
  std::uint8_t node = 0;
  std::uint16_t counter = 0;
  std::uint16_t day = 0;                ///< since 1 January 1984
  std::optional<double> time_of_day_s;  ///< empty: longer than a day
};

/// The frames of TPDO1 and TPDO2. A value that does not fit becomes the nearest end of the range.
std::array<CanFrame, 2> encode(const Sample& sample, const Model& model);
CanFrame encode(const Condition& condition);

/// True if the sample fits the integers.
bool fits(const Sample& sample, const Model& model);

template <class Field>
void visit_fields(const Condition& m, Field&& field) {
  field("node", m.node);
  field("counter", m.counter);
  field("temperature_k", m.temperature_k);
  field("status", m.status);
}

template <class Field>
void visit_fields(const DeviceTime& m, Field&& field) {
  field("node", m.node);
  field("counter", m.counter);
  field("day", m.day);
  field("time_of_day_s", m.time_of_day_s);
}

using Message =
    std::variant<cia404_imu::ImuSet, Condition, DeviceTime, canopen::Heartbeat, canopen::Emergency>;

/// Joins the two halves of each sample by their counter, for any number of nodes. `bad_checksums`
/// counts a half without a partner. Two halves that are exactly 65,536 samples apart have the same
/// counter. Only time shows it, so the driver checks that the frames of a set come within one
/// sample period.
class Decoder {
 public:
  explicit Decoder(const Model& model) : model_(model) {}
  std::optional<Message> receive(const CanFrame& frame);
  const StreamCounters& counters() const { return counters_; }

 private:
  struct Half {
    std::uint16_t counter = 0;
    std::array<std::int16_t, 3> axes{};
  };
  struct Node {
    std::optional<Half> gyro, accelerometer;
  };

  std::optional<Message> receive_half(std::optional<Half> Node::*which, std::uint8_t node,
                                      const CanFrame& frame);
  void drop(std::optional<Half>& half);

  Model model_;
  std::array<Node, 128> nodes_{};
  StreamCounters counters_;
};

}  // namespace drydock::wire::epson

namespace drydock::wire {

struct EpsonG550 {
  static constexpr std::string_view name = "epson-g550";
  static constexpr epson::Model model = epson::g550;
  using Message = epson::Message;
  struct Decoder : epson::Decoder {
    Decoder() : epson::Decoder(model) {}
  };
};

struct EpsonG552 {
  static constexpr std::string_view name = "epson-g552";
  static constexpr epson::Model model = epson::g552;
  using Message = epson::Message;
  struct Decoder : epson::Decoder {
    Decoder() : epson::Decoder(model) {}
  };
};

}  // namespace drydock::wire
