#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/survey/byte_survey.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/j1939/j1939.hpp"

/// Finds the nodes on a CAN bus and their messages. Pure: no socket, no clock.
namespace drydock::survey {

/// An identifier (CANopen, plain CAN) or a PGN (J1939), and its number of frames.
struct Traffic {
  std::uint32_t number = 0;
  std::uint64_t frames = 0;
  std::optional<double> rate_hz;
};

enum class NodeKind : std::uint8_t { j1939, canopen, plain };

/// One sender.
struct Node {
  NodeKind kind = NodeKind::plain;
  std::uint8_t address = 0;  ///< source address or node number; 0: it has none
  std::uint64_t frames = 0;
  std::optional<wire::j1939::Name> name;              ///< from its address claim
  std::optional<wire::canopen::NodeState> state;      ///< from its last heartbeat
  bool booted = false;                                ///< its boot-up message was heard
  std::optional<wire::canopen::Emergency> emergency;  ///< the last one
  std::optional<std::uint32_t> device_type, vendor_id, product_code;  ///< answers to questions
  std::vector<Traffic> traffic;
  /// Drivers that decode plausible measurements from its frames, at most one for each kind of
  /// sensor.
  std::vector<SensorHeard> sensors;
  Confidence confidence = Confidence::nothing;  ///< in the choice of those sensors
  std::string bus{};  ///< the one it is on, of a recording of several; else empty
};

/// An error that the controller reports, in words, and its count.
struct Complaint {
  std::string text;
  std::uint64_t frames = 0;
};

class BusSurvey {
 public:
  using Descriptions = std::vector<wire::described::DescriptionPtr>;

  /// Descriptions with a DBC file come before the protocols of the registry. Those of byte lines
  /// are left out.
  explicit BusSurvey(Descriptions descriptions = {});
  ~BusSurvey();

  void receive(const wire::CanFrame& frame, Stamp at);

  std::uint64_t frames() const { return frames_; }  ///< without error frames
  std::vector<Node> nodes() const;                  ///< J1939, then CANopen, then the rest
  std::vector<Complaint> complaints() const;
  /// Bits on the wire per second, stuffing included; empty without times.
  std::optional<double> bits_per_second() const;

 private:
  class Listener;
  Listener& listener_of(const wire::CanFrame& frame);

  Descriptions descriptions_;
  std::map<std::pair<NodeKind, std::uint8_t>, std::unique_ptr<Listener>> listeners_;
  std::map<std::string, std::uint64_t, std::less<>> complaints_;
  std::uint64_t frames_ = 0, bits_ = 0;
  std::optional<Stamp> first_;
  Stamp last_{};
};

/// Explains to a person why this bus may have no readable frames. Empty if nothing is wrong.
std::string bit_rate_hint(const std::vector<Complaint>& complaints, std::uint64_t frames);

}  // namespace drydock::survey
