#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>

#include "drivers/bus/order_reader.hpp"
#include "hil/motion/steered/steered_trajectory.hpp"
#include "hil/steer/joint_helm.hpp"

namespace drydock::steer {

/// Where it listens, as ROS 2 names the topics.
inline constexpr const char* order_topics =
    "/command/joints (sensor_msgs/JointState) and /command/wrench (geometry_msgs/Wrench)";

/// Steers a vehicle by the orders of other programs on the bus, in bench time, on the thread of the
/// io_context.
class DdsSteering {
 public:
  /// All references must outlive it. Throws bus::Error with one line.
  DdsSteering(boost::asio::io_context& io, const bus::Participant& participant,
              motion::SteeredTrajectory& motion, const rig_config::MissionConfig& mission,
              JointTroublesAt troubles, JointHelm::Say say);

  void start();
  void stop();
  std::vector<std::string> notes() const {
    return notes_of("dds", helm_.counters(), reader_.unusable());
  }

 private:
  void step();

  boost::asio::steady_timer timer_;
  bus::OrderReader reader_;
  motion::SteeredTrajectory& motion_;
  JointHelm helm_;
  JointTroublesAt troubles_;
  Stamp last_{};
  bool stopped_ = false;
};

}  // namespace drydock::steer
