#include "drivers/live/foxglove/access.hpp"

#include <algorithm>

namespace drydock::live {

namespace {

/// "localhost:8765" -> "localhost", "[::1]:8765" -> "::1".
std::string_view without_port(std::string_view host) {
  if (host.starts_with('[')) return host.substr(1, host.find(']') - 1);
  return host.substr(0, host.rfind(':'));
}

/// Takes the same time wherever the first wrong character is.
bool same(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned char different = 0;
  for (std::size_t i = 0; i < a.size(); ++i) different |= static_cast<unsigned char>(a[i] ^ b[i]);
  return different == 0;
}

/// A browser sends "null" for a page that hides its origin; any page can do that.
bool foreign(std::string_view origin) {
  for (const std::string_view scheme : {"http://", "https://"})
    if (origin.starts_with(scheme)) return !is_loopback(without_port(origin.substr(scheme.size())));
  return origin == "null";  // all others are programs, not web pages
}

/// Four numbers, the first 127. Some names begin in the same way: 127.example.org.
bool is_loopback_v4(std::string_view address) {
  if (!address.starts_with("127.") || address.ends_with('.')) return false;
  if (address.find_first_not_of("0123456789.") != std::string_view::npos) return false;
  return std::ranges::count(address, '.') == 3 && address.find("..") == std::string_view::npos;
}

}  // namespace

std::string_view path_of(std::string_view target) { return target.substr(0, target.find('?')); }

std::string_view token_of(std::string_view target) {
  constexpr std::string_view key = "token=";
  auto query = target.substr(path_of(target).size());
  while (!query.empty()) {
    query.remove_prefix(1);  // removes ? or &
    const auto pair = query.substr(0, query.find('&'));
    if (pair.starts_with(key)) return pair.substr(key.size());
    query.remove_prefix(pair.size());
  }
  return {};
}

bool is_loopback(std::string_view address) {
  return address == "localhost" || address == "::1" || is_loopback_v4(address);
}

std::optional<std::string> refusal(const Knock& knock, std::string_view token) {
  if (!token.empty()) {
    if (same(token_of(knock.target), token)) return {};
    return "a token is needed: ?token=... as the program printed it";
  }
  if (!is_loopback(without_port(knock.host))) return "only by the name localhost or its address";
  if (foreign(knock.origin)) return "not for pages of other hosts; start with a token to allow it";
  return {};
}

}  // namespace drydock::live
