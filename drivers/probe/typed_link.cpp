#include "drivers/probe/typed_link.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

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
  return text.find('/') == std::string::npos &&
         typed_fs::exists(root / "sys/class/net" / text, gone);
}

std::string path_link(const typed_fs::path& path) {
  std::error_code gone;
  const auto real = typed_fs::canonical(path, gone);
  if (gone) return path.string();
  const auto absolute = typed_fs::absolute(path).lexically_normal().string();
  if (real.string().starts_with("/dev/pts/")) return "pty:" + absolute;
  if (typed_fs::is_character_file(real, gone)) return "serial:" + absolute;
  return typed_fs::is_regular_file(real, gone) ? "file:" + absolute : path.string();
}

}  // namespace

std::string typed_link(const std::string& text, const std::string& root) {
  if (text.find(':') != std::string::npos && !text.starts_with('/')) return text;
  if (is_can_name(text) || is_interface(text, root)) return "socketcan:" + text;
  if (text.starts_with("/dev/tty") || text.starts_with("/dev/serial/")) return "serial:" + text;
  if (text.starts_with("tty")) return "serial:/dev/" + text;
  return path_link(text);
}

}  // namespace drydock::probe
