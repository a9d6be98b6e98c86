#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/udp.hpp>

#include "hil/steer/autopilot_session.hpp"

namespace drydock::steer {

/// Answers an autopilot on a UDP port, on the thread of the io_context. An answer goes to the
/// address that spoke.
class AutopilotServer {
 public:
  /// `mission.steering` must be set. The motion and the io_context must outlive the server.
  /// `troubles` is asked before each step. Throws std::runtime_error (one line) if the port cannot
  /// be had.
  AutopilotServer(boost::asio::io_context& io, motion::SteeredTrajectory& motion,
                  const rig_config::MissionConfig& mission, JointTroublesAt troubles);

  void stop();
  unsigned short port() const { return socket_.local_endpoint().port(); }
  const AutopilotSession& session() const { return session_; }

 private:
  boost::asio::awaitable<void> serve();

  boost::asio::ip::udp::socket socket_;
  AutopilotSession session_;
  JointTroublesAt troubles_;
};

}  // namespace drydock::steer
