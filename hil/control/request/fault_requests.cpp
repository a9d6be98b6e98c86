#include "hil/control/request/fault_requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "drivers/terminal/duration.hpp"
#include "hil/control/request/order_text.hpp"

namespace drydock::control {

namespace {

using nlohmann::json;

constexpr std::size_t longest_text = 200, most_pairs = 10;

const std::string& text_of(const json& value, std::string_view key) {
  const auto* text = value.get_ptr<const std::string*>();
  if (text == nullptr || text->size() > longest_text)
    throw std::runtime_error(fmt::format("\"{}\": a text of at most {} bytes", key, longest_text));
  return *text;
}

std::string text_in(const json& request, const char* key) {
  const auto found = request.find(key);
  return found == request.end() ? std::string() : text_of(*found, key);
}

std::vector<std::string> pairs_in(const json& request) {
  const auto found = request.find("with");
  if (found == request.end()) return {};
  if (!found->is_array() || found->size() > most_pairs)
    throw std::runtime_error(fmt::format("\"with\": at most {} texts KEY=VALUE", most_pairs));
  std::vector<std::string> pairs;
  for (const json& pair : *found) pairs.push_back(text_of(pair, "with"));
  return pairs;
}

double duration_in(const json& request) {
  const std::string text = text_in(request, "for");
  if (text.empty()) return 0;
  const auto seconds = terminal::parse_duration(text);
  if (!seconds) throw std::runtime_error(terminal::no_duration(text));
  return *seconds;
}

/// Throws std::runtime_error with one line.
json parsed(std::string_view text, std::initializer_list<std::string_view> keys) {
  json request = json::parse(text, nullptr, false);
  if (!request.is_object())
    throw std::runtime_error(fmt::format("a request is a JSON object; keys: {}",
                                         fmt::join(keys.begin(), keys.end(), ", ")));
  for (const auto& [key, value] : request.items())
    if (std::ranges::find(keys, key) == keys.end())
      throw std::runtime_error(fmt::format("\"{}\" is no key of it; keys: {}",
                                           std::string_view(key).substr(0, longest_text),
                                           fmt::join(keys.begin(), keys.end(), ", ")));
  return request;
}

}  // namespace

live::ServiceAnswer order_of_set_request(std::string_view text) try {
  const json request = parsed(text, {"device", "fault", "with", "for"});
  return order_to_set(fault_table(text_in(request, "device"), text_in(request, "fault"),
                                  pairs_in(request), duration_in(request)));
} catch (const std::runtime_error& wrong) {
  return live::Refused{wrong.what()};
}

live::ServiceAnswer order_of_clear_request(std::string_view text) try {
  const json request = parsed(text, {"device", "fault"});
  return order_to_clear(text_in(request, "device"), text_in(request, "fault"));
} catch (const std::runtime_error& wrong) {
  return live::Refused{wrong.what()};
}

}  // namespace drydock::control
