#pragma once

#include "drivers/device/bus/bus_driver.hpp"
#include "drivers/device/bus/node_search.hpp"
#include "drivers/device/bus/source_filter.hpp"
#include "drivers/wire/nmea2000/nmea2000.hpp"

namespace drydock::device {

/// The common parts of drivers on NMEA 2000. They claim no address. The only message that they send
/// is a request for the NAMEs on the bus, when it opens or their sensor is silent.
class Nmea2000Driver : public BusDriver<wire::Nmea2000> {
 public:
  void restart(Stamp now, Output& out) override { search_.restart(now, out); }
  void tick(Stamp now, Output& out) override { search_.tick(now, out); }
  std::optional<Stamp> deadline() const override { return search_.deadline(); }

 protected:
  using BusDriver::BusDriver;

  bool accepts(SourceFilter& filter, std::uint8_t source, Stamp now) {
    const bool ours = filter.accepts(source, now);
    if (ours) search_.heard(now);
    return ours;
  }

 private:
  NodeSearch search_;
};

}  // namespace drydock::device
