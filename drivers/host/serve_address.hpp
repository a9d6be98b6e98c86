#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>

namespace drydock::host {

struct ServeAddress {
  std::string host;  ///< empty: that of the machine itself
  std::uint16_t port = 0;
};

/// Reads PORT or ADDRESS:PORT. Empty: the text is neither.
inline std::optional<ServeAddress> parse_serve_address(const std::string& text) {
  const auto colon = text.rfind(':');
  ServeAddress address;
  if (colon != std::string::npos) address.host = text.substr(0, colon);
  const auto* from = text.data() + (colon == std::string::npos ? 0 : colon + 1);
  const auto* to = text.data() + text.size();
  const auto [end, error] = std::from_chars(from, to, address.port);
  if (error != std::errc{} || end != to) return {};
  return address;
}

/// What to do about a text that is none.
inline std::string no_serve_address(const std::string& text) {
  return "'" + text + "' is no address; allowed: PORT or ADDRESS:PORT, such as 127.0.0.1:8765";
}

}  // namespace drydock::host
