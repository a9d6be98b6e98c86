#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/survey/byte_survey.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/j1939/j1939.hpp"

namespace drydock::survey {

/// An identifier (CANopen, plain CAN) or a PGN (J1939), and its number of frames.
struct Traffic {
  std::uint32_t number = 0;
  std::uint64_t frames = 0;
  std::optional<double> rate_hz;
};

/// `described`: the messages of a description, whoever sends them.
enum class NodeKind : std::uint8_t { described, j1939, canopen, plain };

/// One sender.
struct Node {
  NodeKind kind = NodeKind::plain;
  std::uint8_t address = 0;  ///< source address or node number; 0: it has none
  std::uint64_t frames = 0;
  std::optional<wire::j1939::Name> name;              ///< from its address claim
  std::optional<wire::canopen::NodeState> state;      ///< from its last heartbeat
  bool booted = false;                                ///< its boot-up message was heard
  std::optional<wire::canopen::Emergency> emergency;  ///< the last one
  bool answered = false;                              ///< it answered a question by SDO
  std::optional<std::uint32_t> device_type, vendor_id, product_code;  ///< answers to questions
  std::vector<Traffic> traffic;
  /// Drivers that decode plausible measurements from its frames, at most one for each kind of
  /// sensor.
  std::vector<SensorHeard> sensors;
  Confidence confidence = Confidence::nothing;  ///< in the choice of those sensors
  std::string bus{};            ///< the one it is on, of a recording of several; else empty
  std::string title{};          ///< of a description
  bool only_described = false;  ///< all its identifiers are those of descriptions that were named
  /// What else its frames could be, and what speaks for it.
  std::vector<std::string> also{};

  /// True if it sent what only such a node sends: not only data under identifiers of the profile.
  bool has_proof() const { return name || state || emergency || answered; }
};

}  // namespace drydock::survey
