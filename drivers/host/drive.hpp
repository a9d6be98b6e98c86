#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <functional>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// Gives the viewer its services: requests that a page can make. The returned function is called a
/// few times a second.
using BehindPage = std::function<std::function<void(measurement::Stamp now)>(
    boost::asio::any_io_executor, RigViewer&, Watchers&)>;

struct DriveOptions {
  double duration_s = 0;  ///< 0: until Ctrl-C
  RecordOptions record;
  ServeOptions serve;
  BehindPage behind_page;  ///< may be empty
};

/// Runs the drivers of a rig. They read the links and publish measurements and health on the bus;
/// on request everything is recorded. Returns 0, or 1 if a device was not streaming at the end or
/// the recording failed.
int drive(const rig_config::Rig& rig, const DriveOptions& options);

}  // namespace drydock::host
