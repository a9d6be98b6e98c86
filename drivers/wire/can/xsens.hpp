#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "drivers/wire/can/can_frame.hpp"
#include "drivers/wire/can/xsens_messages.hpp"
#include "drivers/wire/codec.hpp"

/// Xsens MTi 600, Avior and Sirius on CAN: one message per frame; only the identifier tells which.
/// The user may give each message another identifier, of 11 or 29 bits.
namespace drydock::wire::xsens {

using Message =
    std::variant<Error, SampleTime, GroupCounter, StatusWord, Quaternion, EulerAngles, DeltaV,
                 RateOfTurn, DeltaQ, Acceleration, FreeAcceleration, RateOfTurnHr, AccelerationHr,
                 Velocity, Warning, UtcTime, MagneticField, Temperature, Pressure,
                 LatitudeLongitude, Altitude, EcefX, EcefY, EcefZ, GnssStatus, GnssDop>;

/// The identifier of each message, in the order of `Message`.
struct Identifiers {
  static constexpr std::size_t count = std::variant_size_v<Message>;
  /// Factory settings. MT1604P exchanges 061h and 062h; the SDK's enumeration has them as here.
  std::array<std::uint32_t, count> ids{0x01, 0x05, 0x06, 0x11, 0x21, 0x22, 0x31, 0x32, 0x33,
                                       0x34, 0x35, 0x61, 0x62, 0x76, 0x02, 0x07, 0x41, 0x51,
                                       0x52, 0x71, 0x72, 0x73, 0x74, 0x75, 0x79, 0x7A};
  bool extended = false;  ///< 29 bits

  /// Gives the message with that `type` another identifier. False if there is no such message.
  bool set(std::string_view type, std::uint32_t id);
  /// True if all are different and none is too long for its format.
  bool sound() const;
  /// The index in `Message` for the content of a frame.
  std::optional<std::size_t> message_of(const CanFrame& frame) const;
};

CanFrame encode(const Message& message, const Identifiers& identifiers = {});

}  // namespace drydock::wire::xsens

namespace drydock::wire {

struct Xsens {
  static constexpr std::string_view name = "xsens";
  using Message = xsens::Message;

  /// It ignores bytes behind a message's length: some adapters pad to 8 bytes.
  class Decoder {
   public:
    explicit Decoder(const xsens::Identifiers& identifiers = {}) : identifiers_(identifiers) {}
    std::optional<Message> receive(const CanFrame& frame);
    const StreamCounters& counters() const { return counters_; }

   private:
    xsens::Identifiers identifiers_;
    StreamCounters counters_;
  };
};

}  // namespace drydock::wire
