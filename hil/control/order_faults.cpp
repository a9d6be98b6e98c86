#include "hil/control/order_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "drivers/terminal/exit_codes.hpp"
#include "hil/control/control_socket.hpp"
#include "hil/control/fault_words.hpp"
#include "hil/control/request/order_text.hpp"

namespace drydock::control {

namespace {

using Json = nlohmann::ordered_json;

Json asked(const rig_config::Rig& rig, const std::string& order) {
  const std::string path = control_path(rig.name);
  const auto answer = ask(path, order);
  if (!answer)
    throw std::runtime_error(
        fmt::format("no bench of rig \"{}\" runs here ({}: {}); start one: drydock run {}, or "
                    "drydock emulate {}",
                    rig.name, path, answer.error().message(), rig.file, rig.file));
  return Json::parse(*answer);
}

std::string words_of_fault(const Json& fault) {
  const Json& until = fault.at("until_s");
  return fmt::format(
      "{} (since {:.1f} s, {})", fault.at("words").get<std::string>(),
      fault.at("since_s").get<double>(),
      until.is_null() ? "until cleared" : fmt::format("until {:.1f} s", until.get<double>()));
}

int print_answer(const Json& answer, bool json) {
  const bool ok = answer.at("ok");
  if (json) {
    fmt::print("{}\n", answer.dump());
  } else {
    for (const auto& line : answer.at("lines"))
      fmt::print(ok ? stdout : stderr, "{}\n", line.get<std::string>());
  }
  return ok ? terminal::exit_success : terminal::exit_usage;
}

}  // namespace

int set_fault(const rig_config::Rig& rig, const FaultOptions& o) {
  const auto table = fault_table(o.device, o.fault, o.pairs, o.for_s);
  return print_answer(asked(rig, order_to_set(table)), o.json);
}

int clear_faults(const rig_config::Rig& rig, const FaultOptions& o) {
  return print_answer(asked(rig, order_to_clear(o.device, o.fault)), o.json);
}

int list_faults(const rig_config::Rig& rig, const FaultOptions& o) {
  const Json answer = asked(rig, order_to_list());
  if (o.json || !answer.at("ok")) return print_answer(answer, o.json);
  for (const auto& fault : answer.at("faults")) fmt::print("{}\n", words_of_fault(fault));
  if (answer.at("faults").empty()) fmt::print("no fault is in force\n");
  return 0;
}

int show_fault_words(const rig_config::Rig& rig, const FaultOptions& o) {
  if (o.json) {
    fmt::print("{}\n", fault_words_json(rig.devices));
    return 0;
  }
  for (const auto& device : rig.devices) {
    fmt::print("{} ({})\n", device.name, device.protocol);
    for (const auto* word : fault_words_of(device))
      fmt::print("  {:<19}{:<35}{}\n", word->name, amount_keys(*word, device), word->meaning);
  }
  return 0;
}

}  // namespace drydock::control
