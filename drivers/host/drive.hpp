#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <functional>
#include <memory>

#include "drivers/host/beside.hpp"
#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "drivers/host/silence_hints.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Gives the page its services: requests that a viewer can make. Returns a follower of the run,
/// which may tell the other followers what it learns.
using BehindPage = std::function<std::shared_ptr<Follower>(boost::asio::any_io_executor, RigViewer&,
                                                           Follower& others)>;

struct DriveOptions {
  double duration_s = 0;  ///< 0: until Ctrl-C
  RecordOptions record;
  ServeOptions serve;
  BehindPage behind_page;                    ///< may be empty
  Beside beside;                             ///< may be empty
  std::shared_ptr<SilenceHints> hints = {};  ///< may be null
};

/// Runs the drivers of a rig. They read the links and publish measurements and health on the bus;
/// on request everything is recorded. Returns 0, or 1 if a device was not streaming at the end or
/// the recording failed.
int drive(const rig_config::Rig& rig, const DriveOptions& options);

}  // namespace drydock::host
