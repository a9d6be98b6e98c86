#pragma once

#include <map>
#include <span>

#include "drivers/measurement/measurement.hpp"
#include "hil/python/columns.hpp"

namespace drydock::python {

/// Measurements as tables. The columns are `valid_at_ns`, `received_at_ns` and the fields that
/// `drydock decode` and `drydock replay` name; angles are in degrees.
class MeasurementTables {
 public:
  void add(const measurement::Measurement& measurement);

  /// The tables of one device by type of measurement.
  py::dict take(std::uint16_t device);
  /// Those by name of the device, for each that gave a measurement.
  py::dict take(std::span<const std::string> devices);

 private:
  struct Table {
    std::string_view type;
    Columns columns;
  };
  std::map<std::uint16_t, std::map<std::size_t, Table>> tables_;  ///< by device, then by kind
};

}  // namespace drydock::python
