#include "rig_config/toml/checked_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "rig_config/checks/checks.hpp"
#include "rig_config/device_description/load_description.hpp"
#include "rig_config/file_trouble.hpp"
#include "rig_config/nearest_file.hpp"
#include "rig_config/rules/schema_check.hpp"
#include "rig_config/toml/first_table.hpp"
#include "rig_config/toml/toml_limits.hpp"
#include "rig_config/toml/toml_reader.hpp"

namespace drydock::rig_config {

namespace {

namespace fs = std::filesystem;

std::string_view described(FileKind kind) {
  if (kind == FileKind::rig) return "a rig file, which has a table [rig]";
  if (kind == FileKind::mission) return "a mission file, which has a table [mission]";
  if (kind == FileKind::vehicle) return "a vehicle file, which has a table [vehicle]";
  if (kind == FileKind::device) return "a description of a sensor, which has a table [sensor]";
  if (kind == FileKind::fault) return "a fault file, which has blocks [[fault]]";
  return "a sensor file, which has a table for each kind of sensor: [imu], [dvl], ...";
}

/// Empty: the kind has several.
std::string table_of(FileKind kind) {
  if (kind == FileKind::rig) return "rig";
  if (kind == FileKind::mission) return "mission";
  if (kind == FileKind::vehicle) return "vehicle";
  if (kind == FileKind::device) return "sensor";
  return kind == FileKind::fault ? "fault" : "";
}

std::string_view schema_of(FileKind kind) {
  if (kind == FileKind::vehicle) return vehicle_schema_text();
  return kind == FileKind::device ? device_schema_text() : schema_text();
}

bool is_among(const std::vector<DescriptionPtr>& all, std::string_view name) {
  return std::ranges::any_of(all, [&](const DescriptionPtr& one) { return one->name == name; });
}

/// The descriptions that the devices of a rig name, each once.
Problems find_descriptions(const Node& root, const std::string& path,
                           std::vector<DescriptionPtr>& into) {
  Problems problems;
  for_each_table(root, "device", [&](const Node& device, std::size_t i) {
    const Node* protocol = device.find_text("protocol");
    if (!protocol || !is_description(protocol->text)) return;
    if (is_among(into, protocol->text)) return;
    const auto found = find_description(protocol->text, path);
    if (found) return into.push_back(*found);
    for (Problem problem : found.error()) {
      if (problem.line == 0)  // the file itself: the rig's line tells more
        problem = {path, protocol->at.line, protocol->at.column,
                   fmt::format("/device/{}/protocol", i), problem.file + ": " + problem.what};
      problems.push_back(std::move(problem));
    }
  });
  return problems;
}

/// To the schema a description that cannot be used is no protocol; its own problem says why.
void keep_what_descriptions_say(Problems& of_schema, const Node& root,
                                const std::vector<DescriptionPtr>& usable) {
  for_each_table(root, "device", [&](const Node& device, std::size_t i) {
    const Node* protocol = device.find_text("protocol");
    if (protocol && is_description(protocol->text) && !is_among(usable, protocol->text))
      std::erase_if(of_schema, [&](const Problem& p) {
        return p.path == fmt::format("/device/{}/protocol", i);
      });
  });
}

/// A table of a mission in the rig file: the schema alone says that it is not known there.
void tell_where_missions_stand(Problems& of_schema) {
  constexpr std::string_view paths[] = {"/mission",  "/steering", "/ocean",     "/leg",
                                        "/waypoint", "/guidance", "/ballistic", "/track"};
  for (Problem& problem : of_schema)
    if (std::ranges::find(paths, problem.path) != std::end(paths))
      problem.what += fmt::format("; [{}] stands in the file that `mission` of [rig] names",
                                  problem.path.substr(1));
}

void sort_by_position(Problems& problems) {
  std::ranges::stable_sort(problems, [](const Problem& a, const Problem& b) {
    return std::pair(a.line, a.column) < std::pair(b.line, b.column);
  });
}

/// The caller's check of a link gives a better message than the pattern of the schema, which sees
/// only the scheme. So it replaces the schema's problem.
void keep_one_for_each_link(Problems& of_schema, const Problems& of_rig) {
  std::erase_if(of_schema, [&](const Problem& p) {
    return p.path.ends_with("/link") &&
           std::ranges::any_of(of_rig, [&](const Problem& q) { return q.path == p.path; });
  });
}

}  // namespace

FileKind kind_of(const Node& root) {
  if (root.find("rig")) return FileKind::rig;
  if (root.find("sensor")) return FileKind::device;
  if (root.find("vehicle")) return FileKind::vehicle;
  if (root.find("mission")) return FileKind::mission;
  return root.find("fault") ? FileKind::fault : FileKind::sensor;
}

Loaded<std::string> read_file(const std::string& path) {
  std::error_code error;  // a file may be larger than the memory
  if (const auto why = file_trouble(path); !why.empty())
    return Problems{{path, 0, 0, "/", "cannot be read: " + why + nearest_file(path)}};
  auto why = no_text_trouble(path);
  const auto size = fs::file_size(path, error);
  if (size > largest_file)
    return Problems{{path, 0, 0, "/",
                     fmt::format("has {} bytes, allowed: up to {}{}", size, largest_file,
                                 why.empty() ? "" : "; it " + why)}};
  if (!why.empty()) return Problems{{path, 0, 0, "/", std::move(why)}};
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!(text << in.rdbuf())) return Problems{{path, 0, 0, "/", "cannot be read to its end"}};
  return std::move(text).str();
}

Loaded<Node> read_checked(std::string_view text, const std::string& path, FileKind kind,
                          const LoadOptions& options) {
  Loaded<Node> root = read_toml(text, path);
  if (!root) return root;
  if (kind_of(*root) != kind)
    return Problems{without_first_table(*root, path, table_of(kind),
                                        fmt::format("expected {}", described(kind)))};
  std::vector<wire::Protocol> described;  // the descriptions live until the end of the check
  std::vector<DescriptionPtr> descriptions;
  Problems unusable;
  if (kind == FileKind::rig) unusable = find_descriptions(*root, path, descriptions);
  described.reserve(descriptions.size());
  for (const auto& one : descriptions) described.push_back(one->facts);
  Problems problems = check_schema(*root, path, schema_of(kind), described);
  if (kind == FileKind::rig) {
    keep_what_descriptions_say(problems, *root, descriptions);
    tell_where_missions_stand(problems);
  }
  append(problems, std::move(unusable));
  if (kind == FileKind::rig) {
    Problems of_rig = check_rig(*root, path, options);
    keep_one_for_each_link(problems, of_rig);
    append(problems, std::move(of_rig));
  }
  if (kind == FileKind::mission) append(problems, check_mission(*root, path));
  if (kind == FileKind::vehicle) append(problems, check_names(*root, path, "thruster"));
  if (kind == FileKind::mission || kind == FileKind::fault)
    append(problems, check_faults(*root, path));
  sort_by_position(problems);
  if (!problems.empty()) return problems;
  return root;
}

Loaded<Node> read_checked_file(const std::string& path, FileKind kind) {
  const auto text = read_file(path);
  return text ? read_checked(*text, path, kind) : Loaded<Node>(text.error());
}

}  // namespace drydock::rig_config
