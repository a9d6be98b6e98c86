#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>

#include "drivers/recordings/tasks/fixture.hpp"
#include "drivers/recordings/tasks/recordings.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/unkept_path.hpp"

namespace drydock::recordings {

namespace {

namespace fs = std::filesystem;

/// Lists what was moved, dropped and left, one line each: the user must see every change of
/// position.
std::string account_of(const slice::Sliced& done, bool moved) {
  std::string lines;
  if (done.shift.count() != 0)
    lines += fmt::format(
        "time shifted by {:.3f} s; what the devices say of the time in their own bytes and fields "
        "stays\n",
        measurement::seconds(done.shift));
  if (!moved) return lines;
  lines += fmt::format("{} positions moved\n", done.moved);
  for (const auto& [what, count] : done.dropped)
    lines += fmt::format("dropped, since it could tell the place: {} x {}\n", count, what);
  return lines;
}

int refuse_cut(std::FILE* err, std::string_view why) {
  fmt::print(err, "cut: {}\n", why);
  return terminal::exit_failed;
}

std::string note_of(const CutOptions& options, const slice::Sliced& done,
                    std::uint64_t measurements) {
  return fmt::format(
      "# {}\n\nA part of a recorded dive: {} messages of {:.1f} s. `{}` holds what the drivers "
      "made "
      "of its\nbytes when this was written, {} measurements; the ctest `Fixtures/Dive` plays it "
      "again and compares.\n\n{}",
      options.fixture, done.messages,
      done.first ? measurement::seconds(*done.last - *done.first) : 0.0, fixture_reference,
      measurements, account_of(done, options.slice.move_to.has_value()));
}

int write_fixture(const CutOptions& options, const slice::Sliced& done, std::FILE* err) {
  const fs::path folder = fs::path(options.output).parent_path();
  const std::string reference = folder / fixture_reference;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> out(std::fopen(reference.c_str(), "wb"),
                                                            std::fclose);
  if (!out) return refuse_cut(err, reference + ": cannot be written: " + std::strerror(errno));
  const auto measurements = write_reference(options.output, out.get());
  if (!measurements) return refuse_cut(err, measurements.error().line);
  if (*measurements == 0) return refuse_cut(err, "the drivers made no measurement of the slice");
  std::ofstream(folder / "NOTES.md") << note_of(options, done, *measurements);
  fmt::print(err, "{}: {} measurements; add it to git, and ctest runs it\n", folder.string(),
             *measurements);
  return terminal::exit_success;
}

}  // namespace

int cut(CutOptions options, const record::Watch& watch, std::FILE* err) {
  if (!names_what_is_there(options.recording, options.slice.part, "cut", err))
    return terminal::exit_usage;
  const fs::path folder = fs::path(options.fixtures_folder) / options.fixture;
  if (options.output.empty())
    options.output = fs::path(options.recording).stem().string() + "-cut.mcap";
  terminal::UnkeptPath made(options.fixture.empty() ? fs::path(options.output) : folder);
  if (!options.fixture.empty()) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return refuse_cut(err, folder.string() + ": " + error.message());
    options.output = folder / fixture_recording;
  }
  const auto done = slice::slice(options.recording, options.output, options.slice, watch);
  if (!done) return refuse_cut(err, done.error().line);
  fmt::print(err, "{}: {} messages of {:.3f} s{}\n{}", options.output, done->messages,
             done->first ? measurement::seconds(*done->last - *done->first) : 0.0,
             done->ended_early ? ", ended by Ctrl-C" : "",
             account_of(*done, options.slice.move_to.has_value()));
  if (done->messages == 0) return refuse_cut(err, "nothing of the recording is in the slice");
  const int code = options.fixture.empty() ? 0 : write_fixture(options, *done, err);
  if (code == terminal::exit_success) made.keep();
  return code;
}

}  // namespace drydock::recordings
