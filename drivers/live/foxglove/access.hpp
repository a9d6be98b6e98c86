#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drydock::live {

/// The parts of a request that show where it comes from.
struct Knock {
  std::string_view target;  ///< path and query
  std::string_view host;    ///< header Host
  std::string_view origin;  ///< header Origin; empty: not from a web page
};

/// Path without the query.
std::string_view path_of(std::string_view target);
std::string_view token_of(std::string_view target);  ///< value of `token`; empty if there is none

bool is_loopback(std::string_view address);  ///< 127.x.x.x, ::1, localhost

/// The reason to refuse the request, or empty. With a token: the request must have the right one.
/// Without a token (loopback only): the request must use a loopback name for the host, because a
/// foreign web page can make its own name resolve to this machine. A page of another host is
/// refused too.
std::optional<std::string> refusal(const Knock& knock, std::string_view token);

}  // namespace drydock::live
