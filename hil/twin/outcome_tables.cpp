#include "hil/twin/outcome_tables.hpp"

#include <fmt/format.h>

namespace drydock::twin {
namespace {

double empty_percent(const DeviceStatistics& s) {
  if (s.timing.samples == 0) return 0;
  return 100 * static_cast<double>(s.empty) / static_cast<double>(s.timing.samples);
}

report::Table timing_table(const TwinOutcome& outcome) {
  report::Table table{"Rates and gaps",
                      {"device", "samples", "twin", "rate [Hz]", "twin", "lost", "twin",
                       "longest gap [s]", "twin", "without value [%]", "twin"},
                      {},
                      "a sample is lost where the next one comes after more than 1.5 usual steps; "
                      "without value: no bottom lock, no fix"};
  for (const auto& device : outcome.devices) {
    const auto &r = device.recorded, &t = device.twin;
    table.rows.push_back(
        {device.name, fmt::format("{}", r.timing.samples), fmt::format("{}", t.timing.samples),
         fmt::format("{:.4g}", r.timing.rate_hz), fmt::format("{:.4g}", t.timing.rate_hz),
         fmt::format("{}", r.timing.lost), fmt::format("{}", t.timing.lost),
         fmt::format("{:.3g}", r.timing.longest_gap_s),
         fmt::format("{:.3g}", t.timing.longest_gap_s), fmt::format("{:.1f}", empty_percent(r)),
         fmt::format("{:.1f}", empty_percent(t))});
  }
  return table;
}

void add_axes(const DeviceBeside& device, std::size_t place, report::Table& table) {
  const auto &recorded = device.recorded.quantities.at(place),
             &twin = device.twin.quantities.at(place);
  const auto& quantity = recorded.quantity;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto &r = recorded.axes.at(axis), &t = twin.axes.at(axis);
    if (!r) continue;
    std::vector<std::string> row{fmt::format("{}, {} {} [{}]", device.name, quantity.name,
                                             quantity.axes.at(axis), quantity.unit)};
    const auto put = [&](double AxisNoise::*figure) {
      row.push_back(fmt::format("{:.3g}", (*r).*figure / quantity.in_si));
      row.push_back(t ? fmt::format("{:.3g}", (*t).*figure / quantity.in_si) : "none");
    };
    put(&AxisNoise::mean);
    put(&AxisNoise::sigma);
    put(&AxisNoise::white);
    table.rows.push_back(std::move(row));
  }
}

report::Table error_table(const TwinOutcome& outcome) {
  report::Table table{
      "Errors against the track",
      {"quantity", "mean", "twin", "sigma", "twin", "white", "twin"},
      {},
      "measured minus what a perfect sensor would say on the track; white: the part that changes "
      "from sample to sample"};
  for (const auto& device : outcome.devices)
    for (std::size_t place = 0; place < device.recorded.quantities.size(); ++place)
      if (place < device.twin.quantities.size()) add_axes(device, place, table);
  return table;
}

const track::SensorResiduals* same_of(const track::Outcome& outcome,
                                      const track::SensorResiduals& sensor) {
  for (const auto& one : outcome.sensors)
    if (one.device == sensor.device && one.quantity == sensor.quantity) return &one;
  return nullptr;
}

report::Table innovation_table(const TwinOutcome& outcome) {
  report::Table table{"Innovations of the track's filter",
                      {"quantity", "readings", "twin", "RMS", "twin", "NIS", "twin"},
                      {},
                      "NIS: mean normalised square, 1 is consistent"};
  for (const auto& r : outcome.recorded.sensors) {
    const auto* t = same_of(*outcome.sailed, r);
    const auto rms = [](const auto& s) {
      return fmt::format("{:.3g}", track::shown(s.quantity, s.rms));
    };
    table.rows.push_back({fmt::format("{}, {} [{}]", r.device, track::name_of(r.quantity),
                                      track::shown_unit(r.quantity)),
                          fmt::format("{}", r.readings),
                          t ? fmt::format("{}", t->readings) : "none", rms(r), t ? rms(*t) : "none",
                          fmt::format("{:.2f}", r.nis),
                          t ? fmt::format("{:.2f}", t->nis) : "none"});
  }
  return table;
}

}  // namespace

std::vector<report::Table> tables_of(const TwinOutcome& outcome) {
  std::vector<report::Table> tables{timing_table(outcome), error_table(outcome)};
  if (outcome.sailed) tables.push_back(innovation_table(outcome));
  return tables;
}

std::vector<std::string> notes_of(const TwinOutcome& outcome) {
  auto notes = outcome.recorded.notes;
  notes.insert(notes.end(), outcome.notes.begin(), outcome.notes.end());
  const auto& s = outcome.surroundings;
  if (s.bed_depth_m)
    notes.push_back(fmt::format(
        "the bed is flat, {:.2f} m deep; half of the soundings are within {:.2f} m of that",
        *s.bed_depth_m, s.bed_scatter_m));
  if (s.current_ne_mps)
    notes.push_back(
        fmt::format("the current is {:.3f} m/s north, {:.3f} m/s east: log against track",
                    s.current_ne_mps->x(), s.current_ne_mps->y()));
  return notes;
}

}  // namespace drydock::twin
