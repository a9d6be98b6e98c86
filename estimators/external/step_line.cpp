#include "estimators/external/step_line.hpp"

#include <ranges>

#include "drivers/text/json_lines.hpp"
#include "drivers/text/measurement_fields.hpp"

namespace drydock::external {
namespace {

std::int64_t ns(measurement::Stamp at) { return at.time_since_epoch().count(); }

/// A measurement as the other program is told it.
struct ToldSample {
  const pipeline::Sample& sample;
  const std::vector<std::string>& devices;
};

template <class Field>
void visit_fields(const ToldSample& told, Field&& field) {
  const auto& origin = pipeline::origin_of(told.sample);
  field("device", std::string_view{told.devices.at(origin.device)});
  std::visit(
      [&](const auto& sample) {
        field("type", type_of(sample));
        field("valid_at_ns", ns(origin.valid_at));
        field("received_at_ns", ns(origin.received_at));
        visit_fields(sample, field);
      },
      told.sample);
}

}  // namespace

std::string_view StepLines::line_of(const pipeline::Step& step) {
  text_.clear();
  text::JsonWriter json(text_);
  json.open();
  json.field("step", step.number);
  json.field("now_ns", ns(step.now));
  json.field("measurements", step.samples | std::views::transform([this](const auto& sample) {
                               return ToldSample{sample, devices_};
                             }));
  json.close();
  return text_.view();
}

}  // namespace drydock::external
