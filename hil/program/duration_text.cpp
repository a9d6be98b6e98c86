#include <fmt/format.h>

#include "drivers/terminal/duration.hpp"
#include "hil/program/commands.hpp"

namespace drydock::cli {

const CLI::Validator duration_text(
    [](std::string& text) {
      const auto seconds = parse_duration(text);
      if (!seconds) return no_duration(text);
      text = fmt::format("{}", *seconds);
      return std::string{};
    },
    "DURATION");

}  // namespace drydock::cli
