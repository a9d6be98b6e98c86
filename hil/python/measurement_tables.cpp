#include "hil/python/measurement_tables.hpp"

#include "drivers/text/measurement_fields.hpp"

namespace drydock::python {

void MeasurementTables::add(const measurement::Measurement& measurement) {
  std::visit(
      [&](const auto& m) {
        auto& table = tables_[m.origin.device][measurement.index()];
        table.type = type_of(m);
        table.columns.begin_row();
        table.columns.field("valid_at_ns", m.origin.valid_at.time_since_epoch().count());
        table.columns.field("received_at_ns", m.origin.received_at.time_since_epoch().count());
        visit_fields(
            m, [&](std::string_view name, const auto& value) { table.columns.field(name, value); });
      },
      measurement);
}

py::dict MeasurementTables::take(std::uint16_t device) {
  py::dict tables;
  for (auto& [kind, table] : tables_[device])
    tables[py::str(std::string(table.type))] = table.columns.take();
  return tables;
}

py::dict MeasurementTables::take(std::span<const std::string> devices) {
  py::dict all;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    py::dict tables = take(static_cast<std::uint16_t>(i));
    if (!tables.empty()) all[py::str(devices[i])] = std::move(tables);
  }
  return all;
}

}  // namespace drydock::python
