#include "hil/program/options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

#include "drivers/host/serve_address.hpp"
#include "drivers/terminal/data_size.hpp"
#include "drivers/terminal/duration.hpp"
#include "rig_config/file_trouble.hpp"
#include "rig_config/nearest_file.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

const CLI::Validator duration_text(
    [](std::string& text) {
      const auto seconds = terminal::parse_duration(text);
      if (!seconds) return terminal::no_duration(text);
      text = fmt::format("{}", *seconds);
      return std::string{};
    },
    "DURATION");

const CLI::Validator running_time(
    [](std::string& text) {
      const std::string asked = text;
      if (auto why = duration_text(text); !why.empty()) return why;
      if (terminal::parse_duration(text).value_or(0) > 0) return std::string{};
      return fmt::format("'{}' is no time to run; allowed: 90, 60s, 10min, 5.5h", asked);
    },
    "DURATION");

const CLI::Validator positive_number(
    [](std::string& text) {
      double value = 0;
      if (CLI::detail::lexical_cast(text, value) && value > 0 && std::isfinite(value))
        return std::string{};
      return fmt::format("'{}' is not allowed; allowed: a number above 0", text);
    },
    "NUMBER");

const CLI::Validator seed_number(
    [](std::string& text) {
      std::uint64_t seed = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
      if (error == std::errc{} && end == text.data() + text.size()) return std::string{};
      return fmt::format("'{}' is no seed; allowed: a whole number, 0 or more", text);
    },
    "SEED");

const CLI::Validator rig_name(
    [](std::string& text) {
      const std::string asked =
          std::exchange(text, rig_config::find_shipped(text, rig_config::rigs));
      const auto why = rig_config::file_trouble(text);
      return why.empty() ? why : asked + ": " + why + rig_config::nearest_file(asked);
    },
    "RIG");

namespace {

const CLI::Validator serve_address(
    [](std::string& text) {
      return host::parse_serve_address(text) ? std::string{} : host::no_serve_address(text);
    },
    "ADDRESS");

}  // namespace

void add_serve(CLI::App& sub, host::ServeOptions& serve, const std::string& more) {
  sub.add_option("--serve", serve.address,
                 "a page for browsers and the Foxglove protocol at PORT or ADDRESS:PORT; default "
                 "127.0.0.1:8765" +
                     more)
      ->expected(0, 1)
      ->default_str("127.0.0.1:8765")
      ->check(serve_address);
  sub.add_option("--token", serve.token,
                 "that a viewer must name; one is made where the address is not loopback");
}

void add_faults_option(CLI::App& sub, std::string& file) {
  sub.add_option("--faults", file, "file of blocks [[fault]], beside those of the rig");
}

void add_allow_faults(CLI::App& sub, host::ServeOptions& serve) {
  sub.add_flag("--allow-faults", serve.allow_faults,
               "viewers may set and clear faults of the emulated devices: docs/use/live.md")
      ->needs("--serve");
}

void add_allow_recording(CLI::App& sub, host::ServeOptions& serve) {
  sub.add_option("--allow-recording", serve.recordings,
                 "viewers may start and stop a recording in this folder: docs/use/live.md")
      ->needs("--serve")
      ->option_text("FOLDER");
}

namespace {

/// The text of an option as a number above 0, or the usage error.
template <class Parse, class Refuse>
auto positive(const char* option, const std::string& text, Parse parse, Refuse refuse) {
  const auto value = parse(text);
  if (!value || !(*value > 0)) throw CLI::ValidationError(option, refuse(text));
  return *value;
}

std::chrono::nanoseconds time_of(const char* option, const std::string& text) {
  return measurement::from_seconds(
      positive(option, text, terminal::parse_duration, terminal::no_duration));
}

std::uint64_t size_of(const char* option, const std::string& text) {
  return positive(option, text, terminal::parse_data_size, terminal::no_data_size);
}

}  // namespace

void add_recording(CLI::App& sub, host::RecordOptions& record) {
  auto* overwrite = sub.add_flag("--overwrite", record.overwrite, "replace what is there");
  auto& split = record.split;
  const auto into_files =
      "begin a new file, FILE-0001.mcap, FILE-0002.mcap, ..., when the present one ";
  auto* by_size = sub.add_option_function<std::string>(
      "--split-size", [&](const auto& text) { split.size = size_of("--split-size", text); },
      std::string(into_files) + "has this size: 512MiB");
  auto* by_time = sub.add_option_function<std::string>(
      "--split-every", [&](const auto& text) { split.every = time_of("--split-every", text); },
      std::string(into_files) + "covers this time: 10min");
  for (auto* option : {by_size, by_time}) option->excludes(overwrite);
  sub.add_option_function<std::string>(
      "--keep",
      [&, by_size, by_time](const auto& text) {
        if (by_size->count() + by_time->count() == 0)
          throw CLI::ValidationError("--keep", "needs --split-size or --split-every");
        if (terminal::parse_duration(text))
          split.keep_for = time_of("--keep", text);
        else
          split.keep_size = size_of("--keep", text);
      },
      "of a split recording only the last 24h, or the last 20GiB: older files of this run are "
      "deleted");
}

void add_realtime(CLI::App& sub, RealtimeOptions& realtime) {
  auto* flag = sub.add_flag(
      "--realtime", realtime.wanted,
      "SCHED_FIFO and locked memory, for a loop that is late less often: docs/real-time.md");
  sub.add_option("--priority", realtime.scheduling.priority, "of SCHED_FIFO")
      ->check(CLI::Range(1, 99))
      ->capture_default_str()
      ->needs(flag);
  sub.add_option("--cores", realtime.scheduling.cores,
                 "processors that may run the loop: 2 or 2,3; default all")
      ->delimiter(',')
      ->check(CLI::Range(0, 1023))
      ->needs(flag);
}

void claim(const RealtimeOptions& realtime) {
  if (!realtime.wanted) return;
  const auto claimed = io::claim(realtime.scheduling);
  if (!claimed) throw CLI::ValidationError("--realtime", claimed.error().message);
  fmt::print(stderr, "real time: SCHED_FIFO at priority {}, memory locked\n",
             realtime.scheduling.priority);
}

}  // namespace drydock::program
