#pragma once

#include <optional>
#include <vector>

#include "drivers/diagnosis/monitors/bus_addresses.hpp"
#include "drivers/diagnosis/monitors/bus_silence.hpp"
#include "drivers/diagnosis/monitors/expected.hpp"
#include "drivers/diagnosis/monitors/strange_frames.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"
#include "drivers/diagnosis/monitors/time_monitor.hpp"
#include "drivers/diagnosis/monitors/usual_identifiers.hpp"
#include "drivers/wire/can/can_frame.hpp"

namespace drydock::diagnosis {

/// Watches all frames of one CAN bus: who takes it, what was not there before, whether this
/// computer's controller has left it, whether an address has two owners. Signs of the bus are told
/// of each of its devices. Sans-I/O; no allocation after construction.
class BusMonitor {
 public:
  /// The identifiers of the first so much time are the usual ones.
  static constexpr std::chrono::seconds learning{30};

  /// The sink must outlive the monitor.
  BusMonitor(const std::vector<Expected>& devices, SymptomSink& to);

  void set_bitrate(unsigned bits_per_s) { bitrate_ = bits_per_s; }
  /// `host`: what this computer may have added to its arrival.
  void take(const wire::CanFrame& frame, Stamp at, HostLate host = {});
  /// Tells what lasts. Call it about every look_period.
  void look(Stamp now);

 private:
  struct Node {
    Expected expected;
    Teller teller;
    TimeMonitor frames;            ///< half a sample shows here, and only here
    Stamp pushed_until{};          ///< until then another node's drift explains its own
    unsigned busy_frames = 0;      ///< its own since there was no pause
    unsigned follows_strange = 0;  ///< its frames that came right behind a strange one
  };
  using Usual = UsualIdentifiers::Usual;

  void note_deafness(Stamp at);
  void note_busy(const wire::CanFrame& frame, Stamp at);
  void take_error(const wire::CanFrame& frame, Stamp at);
  /// A node is silent while it claims another address.
  void excuse_robbed() {
    for (Node& node : nodes_)
      if (robbed_since(node)) node.frames.interrupt();
  }
  void take_data(const wire::CanFrame& frame, Stamp at);
  void judge_identifier(const wire::CanFrame& frame, Stamp at);
  bool is_usual(const wire::CanFrame& frame, Stamp at);
  bool has_a_known_sender(const wire::CanFrame& frame) const;
  void judge_size(Usual& usual, const wire::CanFrame& frame, Stamp at);
  void watch_times(Usual& usual, const wire::CanFrame& frame, Stamp at);
  void note_strange(Stamp at);
  void look_at_load(Stamp now);
  void look_at_drift(Stamp now);
  void look_at_strange(Stamp now);
  void tell_all(Sign sign, Stamp since, Stamp now, const Amount& amount) {
    for (const Node& node : nodes_) node.teller.tell(sign, since, now, amount);
  }
  Node* owner_of(const wire::CanFrame& frame);
  const Node* node_at(std::uint8_t address) const;
  std::optional<Stamp> robbed_since(const Node& node) const;
  bool sends_from(std::uint8_t address) const;

  std::vector<Node> nodes_;
  const Node* drifts_ = nullptr;  ///< its clock's rate changed; null: none
  unsigned bitrate_ = 250'000;
  std::optional<Stamp> first_;
  UsualIdentifiers usual_;
  BusAddresses addresses_;
  StrangeFrames strange_;
  bool off_ = false;
  Stamp off_since_{};
  Stamp window_from_{};
  double new_bits_ = 0;                    ///< of unusual identifiers since window_from_
  Stamp last_{}, busy_since_{};            ///< the latest frame; since when there was no pause
  unsigned busy_frames_ = 0;               ///< since then
  std::chrono::nanoseconds usual_busy_{};  ///< the longest time without a pause at first
  BusSilence silence_;
  HostLate host_;  ///< of the latest frame
};

}  // namespace drydock::diagnosis
