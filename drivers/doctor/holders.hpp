#pragma once

#include <string>
#include <vector>

namespace drydock::doctor {

/// A process that has a port open.
struct Holder {
  std::string name, process;  ///< its program, its number
};

/// The real path of a port: rigs use links in /dev/serial/by-id, ptys have links with their names.
std::string real_path(const std::string& root, const std::string& path);

/// The other processes that read a port, as far as this user may see them. `path`: as a rig names
/// it. The program that made a pty holds it too, but is no reader. `root` is "/" except in tests.
std::vector<Holder> holders_of(const std::string& root, const std::string& path);

/// "gpsd (process 123), drydock (process 456)".
std::string in_words(const std::vector<Holder>& holders);

}  // namespace drydock::doctor
