#include "drivers/link/serial/name_claim.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/un.h>

#include <cstring>
#include <filesystem>

namespace drydock::link {
namespace {

/// Of the path itself, without what links make of it. The kernel takes 107 characters, so the name
/// has the end of the path and its hash.
std::string claim_of(const std::string& path) {
  std::error_code none;
  const std::filesystem::path asked(path);
  const auto folder = std::filesystem::weakly_canonical(asked.parent_path(), none);
  const std::string whole = (folder / asked.filename()).string();
  constexpr std::size_t longest = 64;
  return fmt::format("drydock-name-{:016x}-{}", std::hash<std::string>{}(whole),
                     whole.substr(whole.size() - std::min(whole.size(), longest)));
}

}  // namespace

boost::system::result<Descriptor, OpenError> claim_name(const std::string& path) {
  Descriptor socket(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0));
  if (!socket) return open_error(errno, "cannot claim " + path);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  const std::string name = claim_of(path);
  std::memcpy(address.sun_path + 1, name.data(), name.size());  // behind a zero: no file
  const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (::bind(socket.get(), reinterpret_cast<const sockaddr*>(&address), size) == 0) return socket;
  if (errno != EADDRINUSE) return open_error(errno, "cannot claim " + path);
  return OpenError{system_error(EADDRINUSE),
                   path +
                       " is a device of another program that runs; end that one, or give this "
                       "device another name"};
}

}  // namespace drydock::link
