#pragma once

#include "drivers/device/bus/pdo_reader.hpp"
#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::device {

/// Whether a PDO may go on after the objects that a protocol reads.
enum class LongerPdos : std::uint8_t { refused, read };

/// Sees whether the PDOs of a node are those that its protocol usually has. If one of them has
/// another length, or does not come from a node that is operational, it asks the node once what it
/// sends, reads that, and says so. A PDO of the usual number and length with other objects cannot
/// be told from a usual one.
class PdoWatch {
 public:
  static constexpr std::chrono::seconds patience{3};

  /// `usual`: of this node. Without any, frames pass as they are.
  PdoWatch(std::uint8_t node, PdoTranslator::Pdos usual, LongerPdos longer)
      : node_(node), longer_(longer), translator_(usual) {}

  void restart();
  /// The frames to decode for one frame of the bus.
  std::span<const wire::CanFrame> frames_of(const wire::CanFrame& frame, Stamp at, Output& out);
  void on(const wire::canopen::Heartbeat& heartbeat, Stamp at, Output& out);
  void tick(Stamp now, Output& out);
  std::optional<Stamp> deadline() const;

 private:
  void look_at(const wire::CanFrame& frame, Stamp at, Output& out);
  void conclude(Output& out);
  void ask(Stamp now, Output& out);
  std::size_t first_silent() const;
  bool all_came() const { return first_silent() == translator_.usual().size(); }
  bool has_stopped(Stamp now) const;

  std::uint8_t node_;
  LongerPdos longer_;
  PdoTranslator translator_;
  PdoReader reader_;
  std::array<std::optional<Stamp>, PdoTranslator::most> came_{};  ///< usual PDOs, the last time
  std::optional<Stamp> patient_until_;
  bool asked_ = false;
  bool other_length_ = false;
};

}  // namespace drydock::device
