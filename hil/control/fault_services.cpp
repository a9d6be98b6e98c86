#include "hil/control/fault_services.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "hil/control/fault_words.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/control/request/fault_requests.hpp"
#include "hil/control/request/order_text.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::control {

namespace {

using live::Service;
using OrderOf = live::ServiceAnswer (*)(std::string_view request);

constexpr const char* set_schema = R"({"type":"object","required":["device","fault"],"properties":{
"device":{"type":"string"},"fault":{"type":"string"},
"with":{"type":"array","items":{"type":"string"}},"for":{"type":"string"}}})";
constexpr const char* clear_schema = R"({"type":"object","properties":{
"device":{"type":"string"},"fault":{"type":"string"}}})";
constexpr const char* empty_schema = R"({"type":"object","properties":{}})";
constexpr const char* faults_schema = R"({"type":"object","properties":{"ok":{"type":"boolean"},
"lines":{"type":"array","items":{"type":"string"}},"now_s":{"type":"number"},
"faults":{"type":"array","items":{"type":"object","properties":{"device":{"type":"string"},
"fault":{"type":"string"},"words":{"type":"string"},"since_s":{"type":"number"},"until_s":{"type":"number"}}}}}})";

/// A refusal comes as several lines; a service caller gets them joined into one text.
live::ServiceAnswer answer_of(const std::string& line) {
  const auto answer = nlohmann::json::parse(line, nullptr, false);
  if (answer.is_object() && answer.value("ok", false)) return line;
  std::string why;
  if (answer.is_object())
    for (const auto& part : answer.value("lines", nlohmann::json::array()))
      if (part.is_string()) why += (why.empty() ? "" : "; ") + part.get<std::string>();
  return live::Refused{why.empty() ? "the bench gave no answer" : why};
}

Service ordering(const char* name, const char* type, const char* schema, OrderOf order_of,
                 const Obey& obey) {
  const auto serve = [order_of, obey](std::string_view request, const Service::Answered& answered) {
    const auto wanted = order_of(request);
    const auto* order = std::get_if<std::string>(&wanted);
    if (order == nullptr) return answered(wanted);
    obey(*order, [answered](const std::string& line) { answered(answer_of(line)); });
  };
  return {name, type, schema, faults_schema, serve};
}

live::ServiceAnswer order_of_list_request(std::string_view) { return order_to_list(); }

}  // namespace

std::vector<Service> fault_services(const rig_config::Rig& rig, const Obey& obey) {
  const auto devices = summary::emulated_devices(rig);
  if (devices.empty())
    throw std::runtime_error(
        fmt::format("--allow-faults: no device of {} is emulated, so none can be given a fault; "
                    "between a real one and its drivers: drydock proxy",
                    rig.file));
  const auto words = [text = fault_words_json(devices)](
                         std::string_view, const Service::Answered& answered) { answered(text); };
  return {
      ordering("/drydock/faults/set", "drydock/SetFault", set_schema, order_of_set_request, obey),
      ordering("/drydock/faults/clear", "drydock/ClearFaults", clear_schema, order_of_clear_request,
               obey),
      ordering("/drydock/faults/list", "drydock/ListFaults", empty_schema, order_of_list_request,
               obey),
      {"/drydock/faults/words", "drydock/FaultWords", empty_schema, empty_schema, words}};
}

std::vector<Service> fault_services(const rig_config::Rig& rig, LiveFaults& faults) {
  return fault_services(rig, [&faults](const std::string& order, const auto& answered) {
    answered(faults.answer(order));
  });
}

}  // namespace drydock::control
