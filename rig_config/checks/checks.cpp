#include "rig_config/checks/checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <map>
#include <tuple>

#include "drivers/wire/protocols.hpp"
#include "rig_config/estimator/kinds.hpp"
#include "rig_config/estimator_name.hpp"
#include "rig_config/nearest_file.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/shipped.hpp"

namespace drydock::rig_config {

namespace {

using Kind = Node::Kind;

class RigChecks {
 public:
  RigChecks(const Node& root, const std::string& file, const LoadOptions& options)
      : root_(root), file_(file), options_(options) {}

  Problems run() {
    problems_ = check_names(root_, file_, "device");
    std::ranges::move(check_names(root_, file_, "estimator"), std::back_inserter(problems_));
    no_estimator_is_the_truth();
    links_are_sound();
    lines_are_named_alike();
    addresses_are_unique();
    canopen_nodes_have_addresses();
    if (!options_.devices_only) {
      files_exist();
      estimator_files_exist();
    }
    estimators_devices_exist();
    return std::move(problems_);
  }

 private:
  void no_estimator_is_the_truth() {
    for_each_table(root_, "estimator", [&](const Node& estimator, std::size_t i) {
      const Node* name = estimator.find_text("name");
      if (name && name->text == name_of_truth)
        add(*name, fmt::format("/estimator/{}/name", i),
            "\"truth\" is the name of the true motion, allowed: another name");
    });
  }

  void links_are_sound() {
    if (!options_.link_check) return;
    for_each_table(root_, "device", [&](const Node& device, std::size_t i) {
      const Node* link = device.find_text("link");
      if (!link) return;
      if (const auto wrong = options_.link_check(link->text))
        add(*link, fmt::format("/device/{}/link", i), *wrong);
    });
  }

  /// A server has many clients and a file many readers; a line is opened once.
  static bool is_line(const std::string& link) {
    return std::ranges::any_of(std::array{"serial:", "pty:", "udp:", "memory:"},
                               [&](std::string_view scheme) { return link.starts_with(scheme); });
  }

  /// Devices share a line that they name with the same words.
  void lines_are_named_alike() {
    std::map<std::string, std::pair<std::string, std::string>> known;
    for_each_table(root_, "device", [&](const Node& device, std::size_t i) {
      const Node* link = device.find_text("link");
      const Node* name = device.find_text("name");
      if (!link || !name || !is_line(link->text)) return;
      const std::string line = link->text.substr(0, link->text.find('?'));
      const auto& [first, written] =
          known.emplace(line, std::pair(name->text, link->text)).first->second;
      if (written != link->text)
        add(*link, fmt::format("/device/{}/link", i),
            fmt::format("{} is the link of '{}' too, which writes {}; devices that share a line "
                        "write its link alike",
                        line, first, written));
    });
  }

  /// A node may be a sensor of several kinds, as a satellite compass is.
  void addresses_are_unique() {
    std::map<std::tuple<std::string, std::int64_t, std::string>, std::string> taken;
    for_each_table(root_, "device", [&](const Node& device, std::size_t i) {
      const Node* link = device.find_text("link");
      const Node* address = device.find("address");
      const Node* name = device.find_text("name");
      const Node* kind = device.find_text("kind");
      if (!link || !name || !kind || !address || address->kind != Kind::integer ||
          !address->integer)
        return;
      const auto [first, fresh] =
          taken.emplace(std::tuple(link->text, address->integer, kind->text), name->text);
      if (!fresh)
        add(*address, fmt::format("/device/{}/address", i),
            fmt::format("{} is already the address of '{}' on {}; each {} on a bus needs its own",
                        address->integer, first->second, link->text, kind->text));
    });
  }

  /// A driver starts its CANopen node. Without an address that would be every node on the bus.
  void canopen_nodes_have_addresses() {
    for_each_table(root_, "device", [&](const Node& device, std::size_t i) {
      const Node* link = device.find_text("link");
      const Node* protocol = device.find_text("protocol");
      if (!link || !protocol || is_never_written(link->text)) return;
      const auto* known = wire::find_protocol(protocol->text);
      if (!known || known->network != wire::Network::canopen) return;
      const Node* address = device.find("address");
      if (address && (address->kind != Kind::integer || address->integer != 0)) return;
      add(address ? *address : device, fmt::format("/device/{}/address", i),
          "a CANopen device needs the node that its driver starts, allowed: 1 to 127 (0 would "
          "start every node on the bus; none is needed on a file: or with listen=1)");
    });
  }

  static bool is_never_written(const std::string& link) {
    const auto has = [&](const char* key) { return link.find(key) != std::string::npos; };
    return link.starts_with("file:") || has("listen=1") || has("mode=listen");
  }

  void files_exist() {
    if (const Node* rig = root_.find("rig"))
      file_exists(rig->find_text("mission"), "/rig/mission", missions);
    for_each_table(root_, "device", [&](const Node& device, std::size_t i) {
      const Node* emulate = device.find("emulate");
      if (!emulate) return;
      file_exists(emulate->find_text("errors"), fmt::format("/device/{}/emulate/errors", i),
                  sensors);
      if (const Node* sky = emulate->find("sky"))
        file_exists(sky->find_text("ephemeris"), fmt::format("/device/{}/emulate/sky/ephemeris", i),
                    {});
    });
  }

  void estimator_files_exist() {
    for_each_table(root_, "estimator", [&](const Node& estimator, std::size_t i) {
      file_exists(estimator.find_text("sensors"), fmt::format("/estimator/{}/sensors", i), sensors);
      file_exists(estimator.find_text("vehicle"), fmt::format("/estimator/{}/vehicle", i),
                  vehicles);
    });
  }

  /// `kind`: of the shipped files that it may be; empty: none.
  void file_exists(const Node* name, const std::string& path, std::string_view kind) {
    if (!name || name->text.empty()) return;
    const std::string full = beside(file_, name->text);
    if (std::filesystem::is_regular_file(full)) return;
    add(*name, path, why_no_file(full, kind));
  }

  void estimators_devices_exist() {
    std::vector<std::string_view> checked{"imu"};
    estimator_devices_exist("imu", "imu");
    for (const EstimatorFacts& facts : estimator_facts)
      for (const auto& [key, kind] : facts.devices) {
        if (std::ranges::find(checked, key) != checked.end()) continue;
        checked.push_back(key);
        estimator_devices_exist(key, to_string(kind));
      }
  }

  void estimator_devices_exist(std::string_view key, std::string_view kind) {
    std::vector<std::string> fitting;
    std::map<std::string, std::string> kind_of;
    for_each_table(root_, "device", [&](const Node& device, std::size_t) {
      const Node* name = device.find_text("name");
      const Node* device_kind = device.find_text("kind");
      if (!name || !device_kind) return;
      kind_of[name->text] = device_kind->text;
      if (device_kind->text == kind) fitting.push_back(name->text);
    });
    const std::string offer = fitting.empty()
                                  ? fmt::format("this rig has no device of kind {}", kind)
                                  : "allowed: " + listed(fitting);
    for_each_table(root_, "estimator", [&](const Node& estimator, std::size_t i) {
      const Node* wanted = estimator.find_text(key);
      if (!wanted || std::ranges::find(fitting, wanted->text) != fitting.end()) return;
      const auto other = kind_of.find(wanted->text);
      const std::string what =
          other == kind_of.end()
              ? fmt::format("no device is named \"{}\"", wanted->text)
              : fmt::format("device \"{}\" is of kind {}", wanted->text, other->second);
      add(*wanted, fmt::format("/estimator/{}/{}", i, key),
          fmt::format("{}{}, {}", what, did_you_mean(wanted->text, fitting), offer));
    });
  }

  void add(const Node& at, std::string path, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, std::move(path), std::move(what)});
  }

  const Node& root_;
  const std::string& file_;
  const LoadOptions& options_;
  Problems problems_;
};

}  // namespace

std::filesystem::path short_name(const std::filesystem::path& path) {
  std::error_code missing;
  const auto normal = path.lexically_normal();
  const bool same = std::filesystem::exists(path, missing)
                        ? std::filesystem::equivalent(path, normal, missing)
                        : !std::filesystem::exists(normal, missing);
  return same ? normal : path;
}

std::string beside(const std::string& file, const std::string& relative) {
  const auto folder = std::filesystem::path(file).parent_path();
  return short_name(folder / relative).string();
}

Problems check_names(const Node& root, const std::string& file, const char* group) {
  Problems problems;
  std::map<std::string, int> line_of;
  for_each_table(root, group, [&](const Node& table, std::size_t i) {
    const Node* name = table.find_text("name");
    if (!name) return;
    const auto [first, fresh] = line_of.emplace(name->text, name->at.line);
    if (!fresh)
      problems.push_back(
          {file, name->at.line, name->at.column, fmt::format("/{}/{}/name", group, i),
           fmt::format("\"{}\" is used twice, first in line {}; each {} needs its own", name->text,
                       first->second, group)});
  });
  return problems;
}

Problems check_rig(const Node& root, const std::string& file, const LoadOptions& options) {
  Problems problems = RigChecks(root, file, options).run();
  std::ranges::move(check_expects(root, file), std::back_inserter(problems));
  std::ranges::move(check_faults(root, file), std::back_inserter(problems));
  return problems;
}

}  // namespace drydock::rig_config
