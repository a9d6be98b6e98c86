#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <functional>

#include "drivers/host/rig_recorder.hpp"
#include "drivers/host/rig_viewer.hpp"
#include "rig_config/rig.hpp"

namespace drydock::host {

/// What a page can be asked for beside what it shows: gives the viewer its services. What comes
/// back is called a few times a second.
using BehindPage = std::function<std::function<void(measurement::Stamp now)>(
    boost::asio::any_io_executor, RigViewer&, Watchers&)>;

struct DriveOptions {
  double duration_s = 0;  ///< 0: until Ctrl-C
  RecordOptions record;
  ServeOptions serve;
  BehindPage behind_page;  ///< may be empty
};

/// Runs the drivers of a rig: links in, measurements and health on the bus, all of it into a
/// recording if wanted. Returns 0, or 1 when a device was not streaming at the end or the recording
/// failed.
int drive(const rig_config::Rig& rig, const DriveOptions& options);

}  // namespace drydock::host
