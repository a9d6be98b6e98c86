#include "drivers/probe/typed_link.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "drivers/link/uri.hpp"

namespace drydock::probe {
namespace {

namespace typed_fs = std::filesystem;

/// The names that Linux gives to CAN interfaces: can0, vcan1, slcan0.
bool is_can_name(std::string_view text) {
  constexpr std::array<std::string_view, 4> names{"can", "vcan", "slcan", "vxcan"};
  return std::ranges::any_of(names, [&](std::string_view name) {
    return text.starts_with(name) && text.size() > name.size() &&
           text.find_first_not_of("0123456789", name.size()) == std::string_view::npos;
  });
}

bool is_interface(const std::string& text, const typed_fs::path& root) {
  std::error_code gone;
  return !text.empty() && text[0] != '.' && text.find('/') == std::string::npos &&
         typed_fs::exists(root / "sys/class/net" / text, gone);
}

std::string path_link(const typed_fs::path& path) {
  std::error_code gone;
  const auto real = typed_fs::canonical(path, gone);
  if (gone) return path.string();
  const auto absolute = typed_fs::absolute(path).lexically_normal().string();
  if (real.string().starts_with("/dev/pts/")) return "pty:" + absolute;
  if (typed_fs::is_character_file(real, gone)) return "serial:" + absolute;
  return typed_fs::is_regular_file(real, gone) ? link::file_uri(absolute) : path.string();
}

}  // namespace

std::string typed_link(const std::string& text, const std::string& root) {
  if (text.find(':') != std::string::npos && !text.starts_with('/')) return text;
  if (is_can_name(text) || is_interface(text, root)) return "socketcan:" + text;
  if (text.starts_with("/dev/tty") || text.starts_with("/dev/serial/")) return "serial:" + text;
  if (text.starts_with("tty")) return "serial:/dev/" + text;
  return path_link(text);
}

std::string path_trouble(const std::string& text) {
  if (text.find(':') != std::string::npos && !text.starts_with('/')) return {};
  std::error_code gone;
  if (typed_fs::is_directory(text, gone))
    return text + " is a folder: name a capture file, a port, a CAN interface or a link";
  if (!typed_fs::exists(text, gone))
    return "there is no file, port or CAN interface \"" + text +
           "\"; a link is scheme:target, as in tcp:10.0.0.1:4001";
  return {};
}

}  // namespace drydock::probe
