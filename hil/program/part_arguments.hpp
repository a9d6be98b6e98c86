#pragma once

#include <fmt/format.h>

#include <optional>
#include <string>
#include <vector>

#include "drivers/recordings/record/selection.hpp"
#include "hil/program/commands.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

/// --only, --from, --to: the same for every command that reads a recording.
struct PartArguments {
  std::vector<std::string> only;
  std::optional<double> from_s, to_s;

  void add_only_and_from(CLI::App& sub) {
    sub.add_option("--only", only, "devices, links or estimators: dvl,imu; default all")
        ->delimiter(',');
    sub.add_option("--from", from_s, "since the recording's start: 90, 60s, 10min")
        ->transform(duration_text);
  }
  void add_to(CLI::App& sub) {
    sub.add_option("--to", to_s, "likewise; default its end")->transform(duration_text);
  }
  /// Throws CLI::ValidationError for a range without any time in it.
  record::Selection selection() const {
    if (from_s && to_s && *to_s <= *from_s)
      throw CLI::ValidationError(
          "--to", fmt::format("the range is reversed or empty: it begins at {:g} s, ends at {:g} s",
                              *from_s, *to_s));
    record::Selection part;
    part.only = only;
    if (from_s) part.from = measurement::from_seconds(*from_s);
    if (to_s) part.to = measurement::from_seconds(*to_s);
    return part;
  }
};

}  // namespace drydock::program
