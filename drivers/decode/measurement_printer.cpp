#include "drivers/decode/measurement_printer.hpp"

#include <fmt/format.h>

#include "drivers/text/measurement_fields.hpp"

namespace drydock::decode {

void MeasurementPrinter::on_measurement(const measurement::Measurement& measurement) {
  ++measurements_;
  std::visit(
      [&](const auto& m) {
        lines_.line([&](text::JsonWriter& json) {
          json.field("type", type_of(m));
          json.field("valid_at_s", measurement::seconds(m.origin.valid_at.time_since_epoch()));
          json.field("received_at_s",
                     measurement::seconds(m.origin.received_at.time_since_epoch()));
          json.fields(m);
        });
      },
      measurement);
  if (live) lines_.flush();
}

void MeasurementPrinter::on_state(const device::Device& device, const device::Transition& change) {
  if (states_ != nullptr) {
    fmt::print(states_, "{:.3f} s {}: {} -> {}: {}\n",
               measurement::seconds(change.at.time_since_epoch()), device.name(),
               to_string(change.from), to_string(change.to), change.why.view());
  }
  if (change.to == device::State::closed && on_closed) on_closed();
}

}  // namespace drydock::decode
