#include "drivers/doctor/doctor.hpp"

#include <fmt/format.h>
#include <sys/timex.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "drivers/link/uri.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_lines.hpp"

namespace drydock::doctor {

constexpr std::string_view to_string(Fitness fitness) {
  constexpr std::array<std::string_view, 3> names{"ok", "advice", "wrong"};
  return names[static_cast<std::size_t>(fitness)];
}

template <class F>
void visit_fields(const Diagnosis& d, F&& field) {
  field("check", d.check);
  field("fitness", to_string(d.fitness));
  field("text", d.text);
  field("command", d.command);
}

namespace {

void add_link(const link::Uri& uri, Needs& needs) {
  if (uri.scheme == link::Scheme::serial) needs.ports.push_back(uri.target);
  if (link::has_line_under(uri)) {
    const auto line = link::line_under(uri);
    if (line.scheme == link::Scheme::serial) needs.ports.push_back(line.target);
  }
  if (uri.scheme == link::Scheme::socketcan) {
    needs.kernel_can = true;
    needs.buses.push_back(uri.target);
    if (uri.query.contains("bitrate")) needs.bitrates[uri.target] = *uri.bitrate();
  }
  needs.can_auto |= uri.scheme == link::Scheme::can_auto;
}

/// Removes repeated names: several devices may share a bus or a port.
void make_unique(std::vector<std::string>& names) {
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
}

}  // namespace

Needs needs_of(const rig_config::Rig& rig) {
  Needs needs;
  needs.whole_machine = false;
  needs.rig_file = rig.file;
  needs.dds = rig.publish;
  for (const auto& device : rig.devices)
    if (const auto uri = link::parse_uri(device.link)) add_link(*uri, needs);
  make_unique(needs.ports);
  make_unique(needs.buses);
  return needs;
}

std::vector<Diagnosis> diagnose(const std::string& root, const Needs& needs) {
  std::vector<Diagnosis> all;
  const auto add = [&](std::vector<Diagnosis> some) {
    std::ranges::move(some, std::back_inserter(all));
  };
  add(check_ports(root, needs));
  add(check_names(root, needs));
  add(check_holders(root, needs));
  add(check_latency(root, needs));
  add(check_drivers(root, needs));
  add(check_can(root, needs));
  add(check_network(root, needs));
  add(check_limits(root));
  add(check_disk("."));
  timex clock{};
  const int code = ::adjtimex(&clock);  // modes 0: the call only reads
  add(check_clock(code, clock.status));
  return all;
}

int doctor(const Needs& needs, bool json, std::FILE* out) {
  const auto all = diagnose("/", needs);
  const bool wrong =
      std::ranges::any_of(all, [](const auto& d) { return d.fitness == Fitness::wrong; });
  if (json) {
    text::JsonLines lines(out);
    lines.line([&](text::JsonWriter& writer) {
      writer.field("ok", !wrong);
      writer.field("checks", all);
    });
    lines.flush();
  } else {
    for (const auto& d : all) {
      fmt::print(out, "{:<7} {:<15} {}\n", to_string(d.fitness), d.check, d.text);
      if (d.fitness != Fitness::ok && !d.command.empty())
        fmt::print(out, "{:<24}{}\n", "", d.command);
    }
  }
  return terminal::exit_of(!wrong);
}

}  // namespace drydock::doctor
