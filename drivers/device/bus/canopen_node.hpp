#pragma once

#include "drivers/device/bus/pdo_watch.hpp"
#include "drivers/device/bus/source_filter.hpp"
#include "drivers/device/driver.hpp"
#include "drivers/device/driver_options.hpp"
#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::device {

/// The duties of a driver for its CANopen node, other than reading process data (CiA 301):
///    NMT        starts the node when the bus opens, when it boots up and when it is
///    pre-operational heartbeat  reports when the node falls silent, restarts or was stopped by
///    somebody else EMCY       reports the node's errors, in words SYNC       sends it if the rig
///    file says that the node samples on SYNC
/// It does not watch a node that sends no heartbeat. With address 0 it starts none; the first
/// node whose process data it accepts is our sensor.
class CanopenNode {
 public:
  /// `usual`: the PDOs that the protocol reads, as node 0 has them.
  CanopenNode(const DriverOptions& options, PdoTranslator::Pdos usual,
              LongerPdos longer = LongerPdos::refused);

  void restart(Stamp now, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const;

  /// The frames to decode for one frame of the bus: itself, or the usual PDOs for those of a node
  /// that was set up in another way. None for a frame of the predefined connection set (CiA 301)
  /// that belongs to another node.
  std::span<const wire::CanFrame> frames_of(const wire::CanFrame& frame, Stamp at, Output& out);

  /// The sensor was configured, or it was heard.
  bool is_known() const { return source_.source().has_value(); }

  /// True if process data of `node` are our sensor's.
  bool accepts(std::uint8_t node, Stamp now) { return source_.accepts(node, now); }
  void on(const wire::canopen::Heartbeat& heartbeat, Stamp at, Output& out);
  void on(const wire::canopen::Emergency& emergency, Output& out) const;

 private:
  bool is_of_another(const wire::CanFrame& frame) const;
  bool ours(std::uint8_t node) const { return source_.source().value_or(node) == node; }
  void watch(const wire::canopen::Heartbeat& heartbeat, Stamp at, Output& out);

  static void start(std::uint8_t node, Output& out);

  std::uint8_t node_;  ///< as configured; 0: any, and none is started
  SourceFilter source_;
  CanopenOptions options_;
  PdoWatch pdos_;
  std::optional<wire::canopen::NodeState> state_;  ///< from the last heartbeat
  std::optional<Stamp> lost_at_;                   ///< the node is then lost
  std::optional<Stamp> next_sync_;
};

}  // namespace drydock::device
