#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace drydock::live {

/// What a request says of where it comes from.
struct Knock {
  std::string_view target;  ///< path and query
  std::string_view host;    ///< header Host
  std::string_view origin;  ///< header Origin; empty: not from a web page
};

/// Path without the query.
std::string_view path_of(std::string_view target);
std::string_view token_of(std::string_view target);  ///< value of `token`; empty without

bool is_loopback(std::string_view address);  ///< 127.x.x.x, ::1, localhost

/// Why the request is refused, if it is. With a token: it must be the right one. Without (loopback
/// only): the host must be named by a loopback name, or a web page elsewhere could have a name of
/// its own resolve to this machine; and a page of another host may not look.
std::optional<std::string> refusal(const Knock& knock, std::string_view token);

}  // namespace drydock::live
