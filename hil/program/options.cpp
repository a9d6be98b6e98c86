#include "hil/program/options.hpp"

#include <fmt/format.h>

#include "drivers/terminal/duration.hpp"

namespace drydock::program {

const CLI::Validator duration_text(
    [](std::string& text) {
      const auto seconds = terminal::parse_duration(text);
      if (!seconds) return terminal::no_duration(text);
      text = fmt::format("{}", *seconds);
      return std::string{};
    },
    "DURATION");

void add_serve(CLI::App& sub, host::ServeOptions& serve, const std::string& more) {
  sub.add_option("--serve", serve.address,
                 "a page for browsers and the Foxglove protocol at PORT or ADDRESS:PORT; default "
                 "127.0.0.1:8765" +
                     more)
      ->expected(0, 1)
      ->default_str("127.0.0.1:8765");
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

void add_overwrite(CLI::App& sub, host::RecordOptions& record) {
  sub.add_flag("--overwrite", record.overwrite, "replace what is there");
}

}  // namespace drydock::program
