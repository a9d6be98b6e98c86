#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/cia404_imu.hpp"

/// Epson's CANopen IMUs (M-G550PC2, M-G552PC1 and PC7, M-A552): CiA 404 with 16-bit integer process
/// values. TPDO1 = counter, gyro X, Y, Z; TPDO2 = counter, accelerometer X, Y, Z; TPDO3 = counter,
/// temperature, reserved, status; TPDO4 = counter and time stamp; little-endian. Equal counters
/// make a sample. Mapping and steps: object dictionaries and README of Epson's own evaluation tool.
namespace drydock::wire::epson {

/// One step of the integers; the frames do not say it, so each model is a protocol of its own.
struct Scale {
  double rate_radps, force_mps2;
};

constexpr double standard_gravity_mps2 = 9.80665;

/// 0.008 deg/s and 0.2 mg, by the values that Epson's tool prints for a G550.
constexpr Scale g550{radians(0.008), 0.2e-3 * standard_gravity_mps2};
/// 0.01515 deg/s and 0.4 mg, stated in the G552's object dictionary.
constexpr Scale g552{radians(0.01515), 0.4e-3 * standard_gravity_mps2};

/// What TPDO1 and TPDO2 of one counter say, along the sensor's own axes.
struct Sample {
  std::uint8_t node = 0;
  std::uint16_t counter = 0;
  std::array<double, 3> rate_radps{}, specific_force_mps2{};
};

/// TPDO3.
struct Condition {
  static constexpr std::string_view type = "condition";
  std::uint8_t node = 0;
  std::uint16_t counter = 0;
  double temperature_k = 0;
  std::uint16_t status = 0;  ///< bits of the maker
};

/// The frames of TPDO1 and TPDO2; what does not fit is held at the ends of the range.
std::array<CanFrame, 2> encode(const Sample& sample, const Scale& scale);
CanFrame encode(const Condition& condition);

/// Whether a sample fits the integers.
bool fits(const Sample& sample, const Scale& scale);

template <class Field>
void visit_fields(const Condition& m, Field&& field) {
  field("node", m.node);
  field("counter", m.counter);
  field("temperature_k", m.temperature_k);
  field("status", m.status);
}

using Message = std::variant<cia404_imu::ImuSet, Condition, canopen::Heartbeat, canopen::Emergency>;

/// Gives samples of any number of nodes, each half joined with the other of its counter. A half
/// whose partner did not come is counted in `bad_checksums`. Partners exactly 65,536 samples apart
/// only time tells apart, so the driver checks that a set's frames come within one sample period.
class Decoder {
 public:
  explicit Decoder(const Scale& scale) : scale_(scale) {}
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

  Scale scale_;
  std::array<Node, 128> nodes_{};
  StreamCounters counters_;
};

}  // namespace drydock::wire::epson

namespace drydock::wire {

struct EpsonG550 {
  static constexpr std::string_view name = "epson-g550";
  static constexpr epson::Scale scale = epson::g550;
  using Message = epson::Message;
  struct Decoder : epson::Decoder {
    Decoder() : epson::Decoder(scale) {}
  };
};

struct EpsonG552 {
  static constexpr std::string_view name = "epson-g552";
  static constexpr epson::Scale scale = epson::g552;
  using Message = epson::Message;
  struct Decoder : epson::Decoder {
    Decoder() : epson::Decoder(scale) {}
  };
};

}  // namespace drydock::wire
