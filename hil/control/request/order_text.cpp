#include "hil/control/request/order_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace drydock::control {

namespace {

using Json = nlohmann::ordered_json;

/// A number, an array or a boolean stays as it is. "1,2,3" becomes an array. Other text is quoted.
std::string toml_value(const std::string& typed) {
  constexpr std::string_view of_numbers = "0123456789+-.eE, []";
  const bool number = !typed.empty() && typed.find_first_of("0123456789") != std::string::npos &&
                      typed.find_first_not_of(of_numbers) == std::string::npos;
  if (!number) return Json(typed).dump();
  if (typed.find(',') != std::string::npos && typed.front() != '[') return "[" + typed + "]";
  return typed;
}

bool is_key(std::string_view key) {
  return !key.empty() && std::ranges::all_of(key, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

}  // namespace

std::string fault_table(const std::string& device, const std::string& fault,
                        const std::vector<std::string>& pairs, double for_s) {
  std::string table =
      fmt::format("[[fault]]\ndevice = {}\nfault = {}\n", Json(device).dump(), Json(fault).dump());
  for (const std::string& pair : pairs) {
    const auto equals = pair.find('=');
    if (equals == std::string::npos || !is_key(std::string_view(pair).substr(0, equals)))
      throw std::runtime_error(fmt::format("\"{}\" is no KEY=VALUE; as in probability=0.5", pair));
    table += pair.substr(0, equals) + " = " + toml_value(pair.substr(equals + 1)) + "\n";
  }
  if (for_s > 0) table += fmt::format("for_s = {}\n", for_s);
  return table;
}

std::string order_to_set(const std::string& table) {
  return Json{{"do", "set"}, {"fault", table}}.dump();
}

std::string order_to_clear(const std::string& device, const std::string& fault) {
  return Json{{"do", "clear"}, {"device", device}, {"kind", fault}}.dump();
}

std::string order_to_list() { return Json{{"do", "list"}}.dump(); }

}  // namespace drydock::control
