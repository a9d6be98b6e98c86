#include <fmt/format.h>

#include "drivers/terminal/duration.hpp"
#include "hil/program/commands.hpp"

namespace drydock::program {

const CLI::Validator duration_text(
    [](std::string& text) {
      const auto seconds = terminal::parse_duration(text);
      if (!seconds) return terminal::no_duration(text);
      text = fmt::format("{}", *seconds);
      return std::string{};
    },
    "DURATION");

}  // namespace drydock::program
