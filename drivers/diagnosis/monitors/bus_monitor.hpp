#pragma once

#include <array>
#include <boost/container/static_vector.hpp>
#include <optional>
#include <vector>

#include "drivers/diagnosis/monitors/expected.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"
#include "drivers/diagnosis/monitors/time_monitor.hpp"
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
    TimeMonitor frames;  ///< half a sample shows here, and only here
    bool robbed = false;
    Stamp robbed_since{};
    unsigned busy_frames = 0;      ///< its own since there was no pause
    unsigned follows_strange = 0;  ///< its frames that came right behind a strange one
  };
  /// Who first claimed an address of J1939.
  struct Claim {
    std::uint8_t address = 0;
    std::uint64_t name = 0;
  };
  struct Usual {
    std::uint32_t key = 0;    ///< identifier
    std::uint64_t sizes = 0;  ///< one bit for each number of bytes that it had
    std::uint64_t data = 0;   ///< the first eight bytes of the latest frame
    std::size_t next = 0;     ///< index of the one that came behind it last time
  };

  void note_deafness(Stamp at);
  void note_busy(const wire::CanFrame& frame, Stamp at);
  void take_error(const wire::CanFrame& frame, Stamp at);
  void take_claim(const wire::CanFrame& frame, Stamp at);
  void judge_identifier(const wire::CanFrame& frame, Stamp at);
  bool is_usual(const wire::CanFrame& frame, Stamp at);
  bool has_a_known_sender(const wire::CanFrame& frame) const;
  void judge_size(Usual& usual, const wire::CanFrame& frame, Stamp at);
  Usual* usual_of(std::uint32_t key);
  bool is_repeated(std::uint32_t key);
  void watch_times(Usual& usual, const wire::CanFrame& frame, Stamp at);
  void note_strange(Stamp at);
  void look_at_load(Stamp now);
  void look_at_drift(Stamp now);
  void look_at_strange(Stamp now);
  void tell_all(Sign sign, Stamp since, Stamp now, const Amount& amount);
  Node* owner_of(const wire::CanFrame& frame);
  Node* node_at(std::uint8_t address);
  bool sends_from(std::uint8_t address) const;

  std::vector<Node> nodes_;
  const Node* drifts_ = nullptr;  ///< its clock's rate changed; null: none
  unsigned bitrate_ = 250'000;
  std::optional<Stamp> first_;
  boost::container::static_vector<Usual, 128> usual_;
  bool too_many_ = false;   ///< usual identifiers than can be kept: none is known to be new
  std::size_t latest_ = 0;  ///< index of the latest usual one
  boost::container::static_vector<Claim, 32> claims_;
  std::array<std::uint32_t, 64> recent_{};  ///< the last ones that are not usual, a ring
  std::size_t next_recent_ = 0;
  bool off_ = false;
  Stamp off_since_{};
  Stamp window_from_{};
  double new_bits_ = 0;                    ///< of unusual identifiers since window_from_
  Stamp last_{}, busy_since_{};            ///< the latest frame; since when there was no pause
  unsigned busy_frames_ = 0;               ///< since then
  std::chrono::nanoseconds usual_busy_{};  ///< the longest time without a pause at first
  double usual_pause_s_ = 0;               ///< between frames
  HostLate host_;                          ///< of the latest frame
  bool behind_strange_ = false;
  Stamp strange_at_{}, strange_since_{};
  unsigned strange_ = 0, strange_told_ = 0;  ///< strange frames of the present bout
};

}  // namespace drydock::diagnosis
