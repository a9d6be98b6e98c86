#include <algorithm>
#include <cctype>

#include "drivers/link/uri.hpp"
#include "hil/twin/rig_text.hpp"

namespace drydock::twin {
namespace {

/// The name of a bus: the last part of its path, letters and digits.
std::string bus_name(const std::string& target) {
  std::string name = target.substr(target.find_last_of("/:") + 1);
  std::erase_if(name, [](unsigned char c) { return std::isalnum(c) == 0; });
  return name.empty() ? "bus0" : name;
}

std::string with_keys(std::string text, const link::Uri& uri,
                      std::initializer_list<const char*> keys) {
  char mark = '?';
  for (const char* key : keys) {
    const auto found = uri.query.find(key);
    if (found == uri.query.end() || found->second == "auto") continue;
    text += mark + found->first + "=" + found->second;
    mark = '&';
  }
  return text;
}

}  // namespace

std::string emulated_link(const std::string& text, const std::string& device, bool frames) {
  const auto uri = link::parse_uri(text).value();
  if (uri.emulated() && uri.scheme != link::Scheme::socketcan) return text;
  if (!frames) return with_keys("pty:" + device, uri, {"baud", "bits", "parity", "stop"});
  return "can:auto?name=" + bus_name(uri.target) +
         "&bitrate=" + std::to_string(uri.bitrate().value_or(250'000));
}

}  // namespace drydock::twin
