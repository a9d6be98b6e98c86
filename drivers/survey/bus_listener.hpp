#pragma once

#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "drivers/survey/described_trial.hpp"
#include "drivers/survey/node.hpp"

namespace drydock::survey {

/// One sender on a bus: its traffic, its reports about itself, and every driver tried on it.
class BusListener {
 public:
  using Descriptions = std::vector<wire::described::DescriptionPtr>;
  /// True for identifiers that belong to a description which was found on the bus.
  using IsTaken = std::function<bool(BusId)>;

  /// Of the descriptions it tries those of J1939, if it is such a sender.
  BusListener(NodeKind kind, std::uint8_t address, const Descriptions& descriptions);

  void receive(const wire::CanFrame& frame, Stamp at);

  /// Sensors whose frames are all taken are none of its own; they stand in `also`.
  Node node(const IsTaken& is_taken) const;
  const std::map<BusId, Arrivals>& heard() const { return heard_; }

 private:
  /// A driver of the registry, and how many of its measurements each identifier completed.
  struct RegistryTrial {
    std::unique_ptr<DriverTrial> driver;
    std::map<BusId, std::uint64_t> completed;

    bool is_taken(const IsTaken& taken) const;
  };

  void hear_claim(const wire::j1939::Identifier& id, const wire::CanFrame& frame);
  void hear_services(const wire::CanFrame& frame);
  void forget_taken_services(const IsTaken& is_taken, Node& node) const;
  void choose_sensors(const IsTaken& is_taken, Node& node) const;
  const DescribedTrial* best_described(Kind kind) const;
  const DriverTrial* best_of(Kind kind, const IsTaken& is_taken, bool taken) const;
  bool may_speak(std::string_view protocol) const;

  Node node_;
  std::map<BusId, Arrivals> heard_;
  std::optional<wire::j1939::Name> reversed_name_;  ///< in the order of Aceinna's fields
  std::uint8_t widest_tpdo1_ = 0;
  std::vector<std::unique_ptr<DescribedTrial>> described_;
  std::vector<RegistryTrial> trials_;
};

}  // namespace drydock::survey
