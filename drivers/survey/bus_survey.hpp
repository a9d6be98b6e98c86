#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/survey/bus_listener.hpp"

/// Finds the nodes on a CAN bus and their messages. Pure: no socket, no clock.
namespace drydock::survey {

/// An error that the controller reports, in words, and its count.
struct Complaint {
  std::string text;
  std::uint64_t frames = 0;
};

class BusSurvey {
 public:
  using Descriptions = std::vector<wire::described::DescriptionPtr>;

  /// Descriptions with a DBC file come before the protocols of the registry. Those of J1939 alone
  /// are looked for at each sender, others on the whole bus: their identifiers may look like those
  /// of any profile. Those of byte lines are left out.
  explicit BusSurvey(const Descriptions& descriptions = {});

  void receive(const wire::CanFrame& frame, Stamp at);

  std::uint64_t frames() const { return frames_; }  ///< without error frames
  /// Those that a description names, then J1939, CANopen, and the rest. A sender of which all
  /// frames are described, and that sent nothing that proves its profile, is none.
  std::vector<Node> nodes() const;
  /// The descriptions that were not found, in words, and why not.
  std::vector<std::string> missed() const;
  std::vector<Complaint> complaints() const;
  /// Bits on the wire per second, stuffing included; empty without times.
  std::optional<double> bits_per_second() const;

 private:
  /// One of the descriptions. Those of J1939 have no driver here: each sender has its own.
  struct Named {
    wire::described::DescriptionPtr description;
    std::unique_ptr<DescribedTrial> trial;
    DescribedMatch match;
  };
  using Trials = std::vector<const DescribedTrial*>;

  BusListener& listener_of(const wire::CanFrame& frame);
  Trials found_on_the_bus() const;
  bool is_named(BusId id) const;

  std::vector<Named> named_;
  Descriptions of_senders_;
  std::map<std::pair<NodeKind, std::uint8_t>, std::unique_ptr<BusListener>> listeners_;
  std::map<std::string, std::uint64_t, std::less<>> complaints_;
  std::uint64_t frames_ = 0, bits_ = 0;
  std::optional<Stamp> first_;
  Stamp last_{};
};

/// Explains to a person why this bus may have no readable frames. Empty if nothing is wrong.
std::string bit_rate_hint(const std::vector<Complaint>& complaints, std::uint64_t frames);

}  // namespace drydock::survey
