#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/survey/byte_survey.hpp"
#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/j1939/j1939.hpp"

/// Who is on a CAN bus, and what do they say? Pure: no socket, no clock.
namespace drydock::survey {

/// An identifier (CANopen, plain CAN) or a PGN (J1939), and how often it came.
struct Traffic {
  std::uint32_t number = 0;
  std::uint64_t frames = 0;
  std::optional<double> rate_hz;
};

enum class NodeKind : std::uint8_t { j1939, canopen, plain };

/// One sender.
struct Node {
  NodeKind kind = NodeKind::plain;
  std::uint8_t address = 0;  ///< source address or node number; 0 for what has none
  std::uint64_t frames = 0;
  std::optional<wire::j1939::Name> name;              ///< by its address claim
  std::optional<wire::canopen::NodeState> state;      ///< by its last heartbeat
  bool booted = false;                                ///< it said so while we listened
  std::optional<wire::canopen::Emergency> emergency;  ///< the last
  std::optional<std::uint32_t> device_type, vendor_id, product_code;  ///< where it was asked
  std::vector<Traffic> traffic;
  /// Drivers that got measurements out of its frames that could be true, one a kind of sensor.
  std::vector<SensorHeard> sensors;
  Confidence confidence = Confidence::nothing;  ///< that it is those sensors
};

/// What the controller complains of, in words, and how often.
struct Complaint {
  std::string text;
  std::uint64_t frames = 0;
};

class BusSurvey {
 public:
  BusSurvey();
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

  std::map<std::pair<NodeKind, std::uint8_t>, std::unique_ptr<Listener>> listeners_;
  std::map<std::string, std::uint64_t, std::less<>> complaints_;
  std::uint64_t frames_ = 0, bits_ = 0;
  std::optional<Stamp> first_;
  Stamp last_{};
};

/// What "no bits that I understand" on this bus hints at, for a person; empty: nothing is wrong.
std::string bit_rate_hint(const std::vector<Complaint>& complaints, std::uint64_t frames);

}  // namespace drydock::survey
