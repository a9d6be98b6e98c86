#include "drivers/link/serial/access_advice.hpp"

#include <fmt/format.h>
#include <grp.h>
#include <sys/stat.h>

#include <array>

namespace drydock::link {
namespace {

/// Its number where it has no name.
std::string group_name(gid_t group) {
  std::array<char, 4096> text;
  ::group entry{};
  ::group* found = nullptr;
  if (::getgrgid_r(group, &entry, text.data(), text.size(), &found) == 0 && found != nullptr)
    return found->gr_name;
  return fmt::format("{}", group);
}

}  // namespace

std::string access_advice(const std::string& path) {
  struct stat port {};
  if (::stat(path.c_str(), &port) != 0) return "drydock doctor tells more";
  constexpr mode_t for_a_group = S_IRGRP | S_IWGRP;
  if (port.st_gid != 0 && (port.st_mode & for_a_group) == for_a_group)
    return "join the group " + group_name(port.st_gid);
  if (port.st_uid != 0) return "it belongs to another user, for himself alone";
  return fmt::format(
      "it is for root alone: sudo chgrp dialout {0} && sudo chmod g+rw {0} until it is plugged in "
      "again, a udev rule for good",
      path);
}

}  // namespace drydock::link
