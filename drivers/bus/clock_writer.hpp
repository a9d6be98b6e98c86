#pragma once

#include "drivers/bus/entity.hpp"
#include "drivers/bus/participant.hpp"
#include "drivers/measurement/stamp.hpp"

namespace drydock::bus {

/// rosgraph_msgs/Clock on `rt/clock`, for ROS 2 nodes that use the time of a simulation.
class ClockWriter {
 public:
  explicit ClockWriter(const Participant& participant);
  void write(measurement::Stamp now);
  std::size_t matched_readers() const;

 private:
  Entity topic_, writer_;
};

}  // namespace drydock::bus
