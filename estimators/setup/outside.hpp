#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "drivers/bus/device.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::setup {

/// How a run reaches estimators in other programs.
struct Outside {
  using Say = std::function<void(const std::string& line)>;
  using Peers = std::map<std::string, std::function<std::unique_ptr<pipeline::Peer>()>>;

  bool lockstep = false;  ///< virtual time waits for each answer
  Say say = {};           ///< gets lines for a person; may be empty
  /// The devices of the rig as the bus calls them; lockstep needs them for estimators on topics.
  std::vector<bus::Device> devices = {};
  Peers peers = {};  ///< by estimator, in the place of the program or topic of the rig
};

}  // namespace drydock::setup
