#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "drivers/survey/described_trial.hpp"
#include "drivers/survey/node.hpp"

namespace drydock::survey {

/// The descriptions that were found on a bus as nodes. A CAN frame does not name its protocol, so
/// each also says what its frames could be instead, and what speaks for that.
class DescribedNodes {
 public:
  explicit DescribedNodes(const std::vector<const DescribedTrial*>& found);

  /// Compares them with one sender. If it stays a node of its own, both say so.
  void compare(const std::map<BusId, Arrivals>& heard, Node& sender, bool stays);
  std::vector<Node> nodes() const;

 private:
  struct Entry {
    const DescribedTrial* trial = nullptr;
    Node node;
    std::array<std::string, 2> unproved{};  ///< numbers of J1939 senders, of CANopen nodes
  };

  std::vector<Entry> entries_;
};

}  // namespace drydock::survey
