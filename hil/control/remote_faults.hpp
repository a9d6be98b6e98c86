#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <memory>
#include <optional>
#include <string>

#include "drivers/host/watcher.hpp"
#include "hil/control/fault_services.hpp"
#include "hil/fault/schedule/schedules.hpp"

namespace drydock::control {

/// The faults of a bench that another program plays, `drydock emulate` of the same rig under the
/// same user, through its control socket: for a page beside the drivers.
class RemoteFaults : public std::enable_shared_from_this<RemoteFaults> {
 public:
  /// The watchers hear which faults are in force, and outlive the executor's work.
  RemoteFaults(boost::asio::any_io_executor executor, const rig_config::Rig& rig,
               host::Watchers& watchers);

  /// Passes an order on. At most `most_asking` at once; the next is refused.
  void obey(const std::string& order, std::function<void(const std::string&)> answered);

  /// A few times a second: asks each second what is in force.
  void tick(measurement::Stamp now);

 private:
  static constexpr int most_asking = 8;

  void take(const std::string& answer, measurement::Stamp now);

  boost::asio::any_io_executor executor_;
  std::string path_, nobody_;
  host::Watchers& watchers_;
  int asking_ = 0;
  measurement::Stamp asked_{};
  std::optional<measurement::Stamp> start_;  ///< of the bench, by this program's clock
  std::vector<fault::FaultNow> told_;
};

}  // namespace drydock::control
