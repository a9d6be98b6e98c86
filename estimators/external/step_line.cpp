#include "estimators/external/step_line.hpp"

#include <span>

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

/// All of a step. (clang 14 cannot read the views of gcc 12's library.)
struct ToldSamples {
  struct Place {
    const pipeline::Sample* at;
    const std::vector<std::string>& devices;
    ToldSample operator*() const { return {*at, devices}; }
    Place& operator++() {
      ++at;
      return *this;
    }
    bool operator!=(const Place& other) const { return at != other.at; }
  };
  Place begin() const { return {samples.data(), devices}; }
  Place end() const { return {samples.data() + samples.size(), devices}; }

  std::span<const pipeline::Sample> samples;
  const std::vector<std::string>& devices;
};

}  // namespace

std::string_view StepLines::line_of(const pipeline::Step& step) {
  text_.clear();
  text::JsonWriter json(text_);
  json.open();
  json.field("step", step.number);
  json.field("now_ns", ns(step.now));
  json.field("measurements", ToldSamples{step.samples, devices_});
  json.close();
  return text_.view();
}

}  // namespace drydock::external
