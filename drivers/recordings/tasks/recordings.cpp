#include "drivers/recordings/tasks/recordings.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/record/recover.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/unkept_path.hpp"
#include "drivers/text/printable.hpp"
#include "rig_config/file_trouble.hpp"

namespace drydock::recordings {

namespace {

int refuse(std::FILE* err, std::string_view command, std::string_view why) {
  fmt::print(err, "{}: {}\n", command, why);
  return terminal::exit_failed;
}

/// "dives/one.mcap" -> "one" and an ending. The result is in the current folder, not beside the
/// recording.
std::string named_after(const std::string& recording, std::string_view ending) {
  return std::filesystem::path(recording).stem().string().append(ending);
}

std::string ending_of(bool damaged, const std::string& damage) {
  return damaged ? fmt::format("; the recording is damaged: {} (drydock recover)", damage) : "";
}

}  // namespace

bool names_what_is_there(const std::string& recording, const record::Selection& part,
                         std::string_view command, std::FILE* err) {
  const auto opened = record::Recording::open(recording);
  const auto wrong = opened ? record::misfit(part, *opened) : std::string{};
  if (!wrong.empty()) fmt::print(err, "{}: {}\n", command, wrong);
  return wrong.empty();
}

int export_recording(ExportOptions options, const record::Watch& watch, std::FILE* err) {
  if (!names_what_is_there(options.recording, options.part, "export", err))
    return terminal::exit_usage;
  const auto& format = exporting::formats.at(static_cast<std::size_t>(options.format));
  auto& path = options.target.path;
  if (path.empty()) path = named_after(options.recording, format.suffix);
  terminal::UnkeptPath made(path);
  const auto done = exporting::export_recording(options.recording, options.part, options.format,
                                                options.target, watch);
  if (!done) return refuse(err, "export", done.error().line);
  for (const auto& note : done->notes) fmt::print(err, "{}\n", text::printable(note));
  if (done->written == 0)
    return refuse(err, "export",
                  fmt::format("nothing in {} that {} could hold", options.recording, format.name));
  made.keep();
  fmt::print(err, "{}: {} {}{}{}\n", path, done->written,
             format.format == exporting::Format::csv      ? "messages"
             : format.format == exporting::Format::nmea   ? "sentences"
             : format.format == exporting::Format::pcapng ? "packets"
             : format.format == exporting::Format::raw    ? "reads and writes"
                                                          : "frames",
             done->ended_early ? ", ended by Ctrl-C" : "",
             ending_of(!done->damage.empty(), done->damage));
  return terminal::exit_success;
}

int recover(const RecoverOptions& options, const record::Watch& watch, std::FILE* err) {
  if (const auto why = rig_config::file_trouble(options.recording); !why.empty())
    return refuse(err, "recover", options.recording + ": " + why);
  auto file = std::make_unique<std::ifstream>(options.recording, std::ios::binary);
  const std::string to =
      options.output.empty() ? named_after(options.recording, "-recovered.mcap") : options.output;
  terminal::UnkeptPath made(to);
  auto sink = mcap::file_sink(to, options.overwrite);
  if (!sink) return refuse(err, "recover", mcap::refused(to, sink.error()));
  mcap::Reader reader(std::move(file));
  std::error_code ignored;
  const auto size = static_cast<double>(std::filesystem::file_size(options.recording, ignored));
  const auto saved = record::recover(reader, std::move(*sink), [&] {
    return watch(static_cast<double>(reader.position()) / size);
  });
  if (saved.error) return refuse(err, "recover", to + ": " + saved.error.message());
  fmt::print(err, "{}: {}\n", options.recording,
             !saved.damage.empty() ? saved.damage
             : saved.ended_early   ? "not read to its end"
                                   : "whole, nothing to mend");
  if (saved.nameless > 0)
    fmt::print(err, "{} messages left out: the channels that say what they are were damaged\n",
               saved.nameless);
  if (saved.messages == 0 && saved.attachments == 0)
    return refuse(err, "recover", "nothing in it could be saved");
  made.keep();
  fmt::print(err, "{}: {} messages of {:.1f} s and {} attachments saved{}\n", to, saved.messages,
             static_cast<double>(saved.last_time - saved.first_time) / 1e9, saved.attachments,
             saved.ended_early ? ", ended by Ctrl-C" : "");
  return terminal::exit_success;
}

}  // namespace drydock::recordings
