#include "drivers/cli/fixture.hpp"

#include "drivers/cli/json_lines.hpp"
#include "drivers/cli/measurement_fields.hpp"
#include "drivers/record/player.hpp"

namespace drydock::cli {

namespace {

class MeasurementLines final : public device::Listener {
 public:
  MeasurementLines(const rig_config::Rig& rig, measurement::Stamp begin, std::FILE* out)
      : rig_(rig), begin_(begin), lines_(out) {}

  void on_measurement(const measurement::Measurement& measurement) override {
    ++count_;
    std::visit([&](const auto& m) { write(m); }, measurement);
  }
  void on_state(const device::Device&, const device::Transition&) override {}

  bool flush() { return lines_.flush(); }
  std::uint64_t count() const { return count_; }

 private:
  void write(const auto& m) {
    lines_.line([&](JsonWriter& json) {
      json.field("device", std::string_view(rig_.devices[m.origin.device].name));
      json.field("type", type_of(m));
      json.field("valid_at_s", measurement::seconds(m.origin.valid_at - begin_));
      json.field("received_at_s", measurement::seconds(m.origin.received_at - begin_));
      json.fields(m);
    });
  }

  const rig_config::Rig& rig_;
  measurement::Stamp begin_;
  JsonLines lines_;
  std::uint64_t count_ = 0;
};

}  // namespace

boost::system::result<std::uint64_t, record::RecordingError> write_measurements(
    const std::string& path, const record::Selection& selection, std::FILE* out) {
  const auto recording = record::Recording::open(path);
  if (!recording) return recording.error();
  const auto rig = record::rig_of(*recording);
  if (!rig) return record::RecordingError{path + ": " + rig.error().line};
  MeasurementLines lines(*rig, recording->begin().value_or(measurement::Stamp{}), out);
  if (const auto played = record::play(path, selection, lines); !played) return played.error();
  if (!lines.flush()) return record::RecordingError{"cannot write the measurements"};
  return lines.count();
}

}  // namespace drydock::cli
