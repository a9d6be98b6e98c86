#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/codec.hpp"
#include "drivers/wire/fields.hpp"

/// CANopen measuring device (CiA 404) profile of a navigation-grade IMU. The process values are
/// REAL32 in three transmit PDOs, because 16-bit rates are too coarse for north finding. TPDO1 =
/// (gx, gy), TPDO2 = (gz, ax), TPDO3 = (ay, az), little-endian, rad/s and m/s2. For each sample
/// they are sent in this order without a pause. docs/sensors/protocols/cia404-imu.md is the
/// definition.
namespace drydock::wire::cia404_imu {

/// One sample along the sensor's own axes. A component that is not a number is empty.
struct ImuSet {
  static constexpr std::string_view type = "imu_set";
  std::uint8_t node = 0;
  std::array<std::optional<double>, 3> rate_radps;
  std::array<std::optional<double>, 3> specific_force_mps2;
};

/// The three frames in the order of sending. Empty components become NaN.
std::array<CanFrame, 3> encode(const ImuSet& set);

template <class Field>
void visit_fields(const ImuSet& m, Field&& field) {
  field("node", m.node);
  field("rate_x_radps", m.rate_radps[0]);
  field("rate_y_radps", m.rate_radps[1]);
  field("rate_z_radps", m.rate_radps[2]);
  field("specific_force_x_mps2", m.specific_force_mps2[0]);
  field("specific_force_y_mps2", m.specific_force_mps2[1]);
  field("specific_force_z_mps2", m.specific_force_mps2[2]);
}

}  // namespace drydock::wire::cia404_imu

namespace drydock::wire {

struct Cia404Imu {
  static constexpr std::string_view name = "cia404-imu";
  using Message = std::variant<cia404_imu::ImuSet, canopen::Heartbeat, canopen::Emergency>;

  /// Gives only complete sets, of any number of nodes. A lost frame drops its set, and
  /// `bad_checksums` counts it once. If three frames in a row are lost across two sets, the frames
  /// do not show it. Only time shows it, so the driver checks that the frames of a set come within
  /// one sample period.
  class Decoder {
   public:
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }

   private:
    struct Set {
      std::uint8_t next = 1;  ///< the next PDO expected
      bool broken = false;    ///< a frame of the set was lost and the loss is counted
      std::uint8_t bytes = 0;
      std::array<float, 6> values{};
    };

    std::optional<Message> receive_pdo(std::uint8_t pdo, std::uint8_t node, const CanFrame& frame);
    void drop(Set& set);

    std::array<Set, 128> sets_{};
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
