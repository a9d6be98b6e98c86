#include "hil/program/man_page.hpp"

#include <fmt/format.h>

#include <sstream>

#include "drivers/terminal/exit_codes.hpp"

namespace drydock::program {
namespace {

/// Escapes text for roff: typed hyphens, backslashes, and lines that would begin with a request.
std::string roff(const std::string& text) {
  std::string out;
  bool line_begins = true;
  for (const char c : text) {
    if (line_begins && (c == '.' || c == '\'')) out += "\\&";
    if (c == '-')
      out += "\\-";
    else if (c == '\\')
      out += "\\e";
    else
      out += c;
    line_begins = c == '\n';
  }
  return out;
}

std::string option_title(const CLI::Option& option) {
  const bool takes_value = option.get_items_expected_max() > 0;
  if (option.get_positional() && option.get_lnames().empty())
    return fmt::format(".I {}\n", roff(option.get_name(true)));
  const std::string name = roff("--" + option.get_lnames().front());
  return takes_value ? fmt::format(".BI {} \" VALUE\"\n", name) : fmt::format(".B {}\n", name);
}

std::string synopsis(const CLI::App& command) {
  std::string text = "drydock " + command.get_name() + " [OPTIONS]";
  for (const auto* option :
       command.get_options([](const CLI::Option* o) { return o->get_positional(); }))
    text += fmt::format(fmt::runtime(option->get_required() ? " {}{}" : " [{}{}]"),
                        option->get_name(true), option->get_items_expected_max() > 1 ? "..." : "");
  return text;
}

std::string example(const CLI::App& command) {
  const std::string footer = command.get_footer();
  return footer.empty() ? std::string() : fmt::format(".PP\n.nf\n{}\n.fi\n", roff(footer));
}

std::string section(const CLI::App& command) {
  std::string text = fmt::format(".SS {}\n.B {}\n.PP\n{}.\n", roff(command.get_name()),
                                 roff(synopsis(command)), roff(command.get_description()));
  for (const auto* option : command.get_options()) {
    if (option->get_name() == "--help" || option->check_name("--help")) continue;
    text += ".TP\n" + option_title(*option) + roff(option->get_description()) + "\n";
  }
  return text + example(command);
}

constexpr std::string_view environment = R"(.SH ENVIRONMENT
.TP
.B ROS_DOMAIN_ID
DDS domain, before the rig file's
.TP
.B CYCLONEDDS_URI
configuration of Cyclone DDS in place of ours
.TP
.B NO_COLOR
set and not empty: no colours on a terminal
.TP
.B XDG_RUNTIME_DIR
where the links to ptys stand
)";

std::string exit_status() {
  std::string text = ".SH EXIT STATUS\n";
  for (const auto& [code, meaning] : terminal::exit_codes)
    text += fmt::format(".TP\n.B {}\n{}\n", code, roff(std::string(meaning)));
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  std::string text = fmt::format(
      ".TH DRYDOCK 1 \"\" \"drydock {}\" \"User Commands\"\n.SH NAME\n"
      "drydock \\- test rig and drivers for underwater navigation sensors\n"
      ".SH SYNOPSIS\n.B drydock\n.I COMMAND\n[OPTIONS]\n.SH DESCRIPTION\n"
      "Real sensors, emulated sensors and recordings stand on the same wires, pass through the "
      "same "
      "drivers and feed the same estimators.\n.SH COMMANDS\n",
      roff(version));
  for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
    text += section(*command);
  return text.append(environment) + exit_status();
}

}  // namespace drydock::program
