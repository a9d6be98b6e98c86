#include <fmt/format.h>
#include <pybind11/stl.h>

#include "drivers/decode/replay.hpp"
#include "hil/python/measurement_tables.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"
#include "hil/python/warn.hpp"
#include "rig_config/device_description/load_description.hpp"

namespace drydock::python {
namespace {

py::dict decode_capture(const std::string& path, const std::string& protocol,
                        const std::string& kind, unsigned baud, const std::string& format,
                        const std::string& clock, const std::string& interface,
                        std::uint8_t address) {
  decode::ReplayOptions options;
  options.capture = path;
  options.protocol = protocol;
  options.kind = kind;
  options.baud = baud;
  options.format = format;
  options.clock = clock;
  options.interface = interface;
  options.address = address;
  MeasurementTables tables;
  std::size_t measurements = 0;
  decode::Played played;
  {
    const OutsidePython others_run;
    if (rig_config::is_description(protocol))
      options.description = rig_config::find_description(protocol, "").value();
    played = decode::play(options, [&](const measurement::Measurement& m) {
      ++measurements;
      tables.add(m);
    });
  }
  const auto& account = played.account;
  if (measurements == 0)
    warn(
        fmt::format("{}: no measurement of {} in it: {} bytes, {} frames, {} bad checksums, {} "
                    "bytes skipped; drydock probe file:PATH says what it looks like",
                    path, protocol, account.bytes_in, account.frames, account.bad_checksums,
                    account.bytes_skipped));
  return tables.take(0);
}

}  // namespace

void add_captures(py::module_& module) {
  using py::arg;
  module.def("decode_capture", &decode_capture, arg("path"), arg("protocol"), py::kw_only(),
             arg("kind") = "", arg("baud") = 0, arg("format") = "", arg("clock") = "",
             arg("interface") = "", arg("address") = 0,
             "The measurements of a capture of one sensor, by type: a table of each.");
}

}  // namespace drydock::python
