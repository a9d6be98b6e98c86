#include "hil/control/orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "rig_config/fault_vocabulary.hpp"

namespace drydock::control {

namespace {

using Json = nlohmann::ordered_json;
using rig_config::FaultKind;

/// The text of a problem without its file position, because no user wrote that file.
std::string line_of(const rig_config::Problem& problem) {
  constexpr std::string_view of_the_table = "/fault/0/";
  if (!problem.path.starts_with(of_the_table)) return problem.what;
  return problem.path.substr(of_the_table.size()) + ": " + problem.what;
}

Json refused(const std::string& why) { return {{"ok", false}, {"lines", {why}}}; }

/// Each line appears once: two checks may report the same problem of one key.
Json refused(const rig_config::Problems& problems) {
  Json lines = Json::array();
  for (const auto& problem : problems)
    if (std::ranges::find(lines, Json(line_of(problem))) == lines.end())
      lines.push_back(line_of(problem));
  return {{"ok", false}, {"lines", lines}};
}

Json set(const std::string& table, fault::Injector& injector, measurement::Stamp now) {
  const auto faults = rig_config::load_faults_text(table, "");
  if (!faults) return refused(faults.error());
  Json answer{{"ok", true}, {"lines", Json::array()}};
  for (const auto& fault : *faults) {
    if (const auto done = injector.set(fault, now); !done) return refused(done.error());
    answer["lines"].push_back(
        fmt::format("set: {}{}", fault.words,
                    fault.for_s ? fmt::format(", for {} s", *fault.for_s) : ", until cleared"));
  }
  return answer;
}

Json clear(const std::string& device, const std::string& word, const rig_config::Rig& rig,
           fault::Injector& injector) {
  if (!device.empty() &&
      std::ranges::find(rig.devices, device, &rig_config::DeviceConfig::name) == rig.devices.end())
    return refused(fmt::format("no device is named \"{}\"", device));
  std::optional<FaultKind> kind;
  if (!word.empty()) {
    const auto* found = rig_config::find_fault(word);
    if (found == nullptr) return refused(fmt::format("there is no fault \"{}\"", word));
    kind = found->kind;
  }
  const std::size_t cleared = injector.clear(device, kind);
  return {{"ok", true}, {"lines", {fmt::format("cleared: {}", cleared)}}};
}

Json obeyed(const Json& order, const rig_config::Rig& rig, fault::Injector& injector,
            measurement::Stamp now) {
  const std::string what = order.at("do");
  if (what == "set") return set(order.at("fault"), injector, now);
  if (what == "clear") return clear(order.at("device"), order.at("kind"), rig, injector);
  if (what == "list") return {{"ok", true}, {"lines", Json::array()}};
  return refused("allowed: set, clear, list");
}

}  // namespace

std::string obey(std::string_view request, const rig_config::Rig& rig, fault::Injector& injector,
                 measurement::Stamp start, measurement::Stamp now) {
  Json answer;
  try {
    answer = obeyed(Json::parse(request), rig, injector, now);
  } catch (const Json::exception&) {
    answer = refused("no order: one line of JSON, {\"do\": \"set\", \"fault\": \"[[fault]]...\"}");
  }
  if (answer.at("ok")) {
    answer["now_s"] = measurement::seconds(now - start);
    answer["faults"] = Json::array();
    for (const auto& fault : injector.in_force(now)) {
      const auto since_s = measurement::seconds(fault.since - start);
      answer["faults"].push_back({{"device", fault.device},
                                  {"fault", fault.name},
                                  {"words", fault.words},
                                  {"since_s", since_s},
                                  {"until_s", nullptr}});
      if (fault.until)
        answer["faults"].back()["until_s"] = measurement::seconds(*fault.until - start);
    }
  }
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace drydock::control
