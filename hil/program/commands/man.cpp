#include <fmt/format.h>

#include "hil/program/commands.hpp"
#include "hil/program/man_page.hpp"

namespace drydock::program {

void add_man(CLI::App& app, Command& command) {
  auto* sub = app.add_subcommand("man", "Print the manual page, in roff");
  sub->footer("Example: drydock man | man -l -");
  sub->callback([&app, &command] {
    command = [&app] {
      fmt::print("{}", man_page(app, app.version()));
      return 0;
    };
  });
}

}  // namespace drydock::program
