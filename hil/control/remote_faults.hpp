#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <memory>
#include <optional>
#include <string>

#include "drivers/host/follower.hpp"
#include "hil/control/fault_services.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::control {

/// The faults of a bench in another program: `drydock emulate` of the same rig and the same user.
/// Orders go through its control socket. A page beside the drivers uses this.
class RemoteFaults final : public host::Follower,
                           public std::enable_shared_from_this<RemoteFaults> {
 public:
  /// `to` hears which faults are in force. It must outlive the work of the executor.
  RemoteFaults(boost::asio::any_io_executor executor, const rig_config::Rig& rig,
               host::Follower& to);

  /// Passes an order on. At most `most_asking` orders wait at once; the next is refused.
  void obey(const std::string& order, std::function<void(const std::string&)> answered);

  void tick(measurement::Stamp now) override;  ///< asks once a second which faults are in force

 private:
  static constexpr int most_asking = 8;

  void take(const std::string& answer, measurement::Stamp now);

  boost::asio::any_io_executor executor_;
  std::string path_, nobody_;
  host::Follower& to_;
  int asking_ = 0;
  measurement::Stamp asked_{};
  std::optional<measurement::Stamp> start_;  ///< start of the bench by this program's clock
  std::vector<fault::FaultNow> told_;
};

}  // namespace drydock::control
