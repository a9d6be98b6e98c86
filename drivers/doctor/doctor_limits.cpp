#include <fmt/format.h>
#include <linux/capability.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "drivers/doctor/doctor.hpp"
#include "drivers/io/scheduling.hpp"

namespace drydock::doctor {
namespace {

/// The rest of the line that begins with `key`, without blanks before it. Empty if there is none.
std::string rest_of_line(const std::filesystem::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(key)) {
      const auto begin = line.find_first_not_of(" \t", key.size());
      return begin == std::string::npos ? std::string() : line.substr(begin);
    }
  return {};
}

/// The soft limit in /proc/self/limits: "0", "8388608", "unlimited".
std::string limit(const std::string& root, const std::string& name) {
  std::istringstream words(
      rest_of_line(std::filesystem::path(root) / "proc/self/limits", "Max " + name));
  std::string soft = "0";
  words >> soft;
  return soft;
}

/// A process with the capability is not bound by the limit.
bool is_capable(const std::string& root, unsigned capability) {
  const auto set = rest_of_line(std::filesystem::path(root) / "proc/self/status", "CapEff:");
  return (std::strtoull(set.c_str(), nullptr, 16) >> capability & 1U) != 0;
}

bool allows(const std::string& limit, long wanted) {
  return limit == "unlimited" || std::atol(limit.c_str()) >= wanted;
}

}  // namespace

/// --realtime needs both: the priority, and the right to lock all memory of the program.
std::vector<Diagnosis> check_limits(const std::string& root) {
  constexpr int priority = io::Scheduling::default_priority;
  const auto highest = limit(root, "realtime priority"), memory = limit(root, "locked memory");
  const bool may_hurry = is_capable(root, CAP_SYS_NICE) || allows(highest, priority);
  const bool may_lock = is_capable(root, CAP_IPC_LOCK) || memory == "unlimited";
  if (may_hurry && may_lock)
    return {
        {"real time", Fitness::ok, "--realtime may raise its priority and lock its memory", ""}};
  std::string refused;
  if (!may_hurry) refused += fmt::format("priorities up to {}, not {}", highest, priority);
  if (!may_lock)
    refused += fmt::format("{}{} B of locked memory, not all", refused.empty() ? "" : "; ", memory);
  return {{"real time", Fitness::advice,
           "--realtime is refused (" + refused +
               "); without it emulated devices may be late on a busy machine",
           "printf '%s - rtprio 99\\n%s - memlock unlimited\\n' \"$USER\" \"$USER\" | sudo tee "
           "/etc/security/limits.d/drydock.conf  # then log in again"}};
}

}  // namespace drydock::doctor
