#include "rig_config/device_description/load_description.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "drivers/wire/described/frame_plan.hpp"
#include "rig_config/checks/checks.hpp"
#include "rig_config/device_description/plan_reader.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/checked_file.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;

bool tells_time(const described::Plan& plan) {
  return std::ranges::any_of(plan.fields, [](const described::Field& field) {
    return field.target == described::Target::time || field.target == described::Target::valid_at;
  });
}

bool can_refuse(const described::Description& description) {
  return std::ranges::any_of(description.start,
                             [](const auto& request) { return !request.refusal.empty(); });
}

void add_facts(const described::FramePlan& plan, wire::Protocol& facts) {
  facts.travels = wire::Travels::as_frames;
  for (const auto& frame : plan.frames) {
    if (frame.is_j1939()) facts.network = wire::Network::j1939;
    if (frame.checksum) facts.checksum = to_string(frame.checksum->checksum);
  }
}

wire::Protocol facts_of(const described::Description& description) {
  wire::Protocol facts;
  facts.name = description.name;
  if (description.kind) facts.kinds = *description.kind;
  const auto& sum = description.plan.checksum;
  if (sum.size() != 0) facts.checksum = sum.name();
  if (tells_time(description.plan)) facts.clock = wire::DeviceClock::yes;
  if (description.frames) add_facts(*description.frames, facts);
  if (!description.start.empty()) facts.settings = wire::Settings::obeyed;
  if (can_refuse(description)) facts.settings = wire::Settings::refusable;
  if (description.kind == DeviceKind::gnss) facts.place = wire::Place::yes;
  return facts;
}

/// `name`: as a rig calls it.
Loaded<DescriptionPtr> load_named(std::string_view text, const std::string& path,
                                  const std::string& name) {
  const auto root = read_checked(text, path, FileKind::device);
  if (!root) return root.error();
  Problems problems;
  auto description =
      std::make_shared<described::Description>(read_description(*root, path, problems));
  if (!problems.empty()) return problems;
  description->name = name;
  description->facts = facts_of(*description);
  return DescriptionPtr(std::move(description));
}

}  // namespace

Loaded<DescriptionPtr> load_description_text(std::string_view text, const std::string& path) {
  return load_named(text, path, std::filesystem::path(path).filename().string());
}

Loaded<DescriptionPtr> load_description(const std::string& path) {
  const auto text = read_file(path);
  return text ? load_description_text(*text, path) : Loaded<DescriptionPtr>(text.error());
}

const std::vector<DescriptionPtr>& shipped_descriptions() {
  static const auto all = [] {
    std::vector<DescriptionPtr> read;
    for (const auto& [name, text] : built_in_descriptions())
      if (auto one = load_description_text(text, std::string(name))) read.push_back(*one);
    return read;
  }();
  return all;
}

Loaded<DescriptionPtr> find_description(const std::string& name, const std::string& near) {
  const std::string path = beside(near, name);
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    const auto text = read_file(path);
    return text ? load_named(*text, path, name) : Loaded<DescriptionPtr>(text.error());
  }
  for (const auto& [built_in, text] : built_in_descriptions())
    if (built_in == name) return load_description_text(text, "rig_config/devices/" + name);
  std::vector<std::string> names;
  for (const auto& built_in : built_in_descriptions()) names.emplace_back(built_in.name);
  return Problems{{path, 0, 0, "/",
                   fmt::format("there is no such description{}; neither as a file nor among those "
                               "of the program: {}",
                               did_you_mean(name, names), listed(names))}};
}

}  // namespace drydock::rig_config
