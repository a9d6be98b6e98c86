#pragma once

#include <string>

namespace drydock::text {

/// A JSON document (nlohmann::json or ordered_json) as text. It never throws: in a text that is not
/// UTF-8, such as the name of a file, U+FFFD stands for each wrong byte. An indent of -1: one line.
template <class Json>
std::string json_of_any_text(const Json& json, int indent = 2) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace drydock::text
