#pragma once

#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::device {

/// What a driver does for its CANopen node beside reading its process data (CiA 301):
///   NMT        starts it when the bus opens, and whenever it boots up or is pre-operational
///   heartbeat  reports when it falls silent, restarts or was stopped by somebody else
///   EMCY       reports what the node complains of, in words
///   SYNC       sends it where the rig file says that the node samples on it
/// A node that sends no heartbeat is not watched. With address 0 every node is started and the
/// first whose process data is accepted is ours.
class CanopenNode {
 public:
  explicit CanopenNode(const DriverOptions& options);

  void restart(Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const;

  /// A frame of the predefined connection set (CiA 301) that is a node's which is not our sensor.
  bool is_of_another(const wire::CanFrame& frame) const;

  /// Whether process data of `node` are our sensor's.
  bool accepts(std::uint8_t node, Stamp now) { return source_.accepts(node, now); }
  void on(const wire::canopen::Heartbeat& heartbeat, Stamp at, Output& out);
  void on(const wire::canopen::Emergency& emergency, Output& out) const;

 private:
  bool ours(std::uint8_t node) const { return source_.source().value_or(node) == node; }
  void watch(const wire::canopen::Heartbeat& heartbeat, Stamp at, Output& out);

  SourceFilter source_;
  CanopenOptions options_;
  std::optional<wire::canopen::NodeState> state_;  ///< by the last heartbeat
  std::optional<Stamp> lost_at_;                   ///< unless a heartbeat comes before
  std::optional<Stamp> next_sync_;
};

}  // namespace drydock::device
