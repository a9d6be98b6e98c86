#include "drivers/recordings/export/exporter.hpp"

namespace drydock::exporting {

namespace {

std::unique_ptr<Exporter> make(Format format, const std::vector<RecordedLink>& links,
                               const Target& to) {
  switch (format) {
    case Format::candump: return make_candump(links, to);
    case Format::pcapng: return make_pcapng(links, to);
    case Format::raw: return make_raw(links, to);
    case Format::csv: return make_csv(to);
    case Format::nmea: return make_nmea(links, to);
  }
  return nullptr;
}

void give(const record::Event& event, const record::Recording& recording,
          const record::Selection& selection, Exporter& to) {
  const auto begin = recording.begin().value_or(record::Stamp{});
  if (const auto* known = std::get_if<record::Understood>(&event)) {
    if (selection.takes(*known->channel) && selection.holds(known->at, begin))
      to.on_message(*known);
    return;
  }
  const auto& raw = std::get<record::RawEvent>(event);
  if (!selection.takes(recording.links()[raw.link]) || !selection.holds(raw.at(), begin)) return;
  if (const auto* read = std::get_if<RawBytes>(&raw.content))
    to.on_bytes(*read, raw.link);
  else
    to.on_frame(std::get<RawFrame>(raw.content), raw.link);
}

}  // namespace

boost::system::result<Exported, record::RecordingError> export_recording(
    const std::string& path, const record::Selection& selection, Format format, const Target& to,
    const record::Watch& watch) {
  auto recording = record::Recording::open(path);
  if (!recording) return recording.error();
  if (auto misfit = record::misfit(selection, *recording); !misfit.empty())
    return record::RecordingError{misfit};
  const auto exporter = make(format, recording->links(), to);
  Exported done;
  while (const auto event = recording->next()) {
    give(*event, *recording, selection, *exporter);
    if (!exporter->error().empty()) break;
    if (!watch(recording->done())) {
      done.ended_early = true;
      break;
    }
  }
  exporter->finish();
  if (const std::string error = exporter->error(); !error.empty())
    return record::RecordingError{error};
  done.written = exporter->written();
  done.damage = recording->damage();
  done.notes = exporter->notes();
  return done;
}

}  // namespace drydock::exporting
