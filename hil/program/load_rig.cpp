#include "hil/program/load_rig.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "drivers/bus/domain.hpp"
#include "drivers/decode/decode.hpp"
#include "drivers/text/printable.hpp"
#include "hil/check/check_rig.hpp"
#include "hil/fault/injector.hpp"
#include "rig_config/load.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::program {

namespace {

/// ROS_DOMAIN_ID chooses the DDS domain, as in every ROS 2 program. It overrides the rig file.
void apply_environment(rig_config::Rig& rig) {
  const char* text = std::getenv("ROS_DOMAIN_ID");
  if (text == nullptr || *text == '\0') return;
  const std::string_view digits(text);
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), rig.dds_domain);
  if (error != std::errc{} || end != digits.data() + digits.size() || rig.dds_domain < 0 ||
      rig.dds_domain > bus::highest_domain) {
    fmt::print(stderr, "drydock: ROS_DOMAIN_ID is '{}'; allowed: 0 to {}\n", digits,
               bus::highest_domain);
    throw BadRig{};
  }
}

[[noreturn]] void refuse(const rig_config::Problems& problems) {
  for (const auto& problem : problems)
    fmt::print(stderr, "{}\n", text::printable(to_string(problem)));
  throw BadRig{};
}

/// " (did you mean 'pd0'?)" of a protocol that nobody has; else empty.
std::string misspelled_protocol(const std::string& protocol) {
  std::vector<std::string> known;
  std::istringstream names(decode::decode_protocols());
  for (std::string name; std::getline(names >> std::ws, name, ',');) known.push_back(name);
  if (protocol.empty() || std::ranges::find(known, protocol) != known.end()) return {};
  for (const auto& description : rig_config::built_in_descriptions())
    known.emplace_back(description.name);
  return rig_config::did_you_mean(protocol, known);
}

}  // namespace

rig_config::Rig load_rig(const std::string& path, check::Use use) {
  auto rig = check::load_sound_rig(rig_config::find_shipped(path, rig_config::rigs), use);
  if (!rig) refuse(rig.error());
  apply_environment(*rig);
  return std::move(*rig);
}

bool names_rig(const std::string& source) {
  return source.ends_with(".toml") || rig_config::find_shipped(source, rig_config::rigs) != source;
}

void add_faults(rig_config::Rig& rig, const std::string& path) {
  rig_config::Problems problems;
  if (!path.empty()) {
    auto faults = rig_config::load_faults(path);
    if (faults)
      std::ranges::move(*faults, std::back_inserter(rig.faults));
    else
      problems = faults.error();
  }
  if (problems.empty()) problems = fault::check_faults(rig);
  if (!problems.empty()) refuse(problems);
}

rig_config::DescriptionPtr load_protocol(const std::string& protocol) {
  if (!rig_config::is_description(protocol)) {
    if (const auto meant = misspelled_protocol(protocol); !meant.empty()) {
      fmt::print(stderr, "--protocol: no driver speaks \"{}\"{}; allowed: {}\n",
                 text::printable(protocol), meant, decode::decode_protocols());
      throw BadRig{};
    }
    return nullptr;
  }
  const auto description = rig_config::find_description(protocol, "");
  if (!description) refuse(description.error());
  return *description;
}

}  // namespace drydock::program
