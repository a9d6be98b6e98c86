#include "drivers/doctor/holders.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <set>

namespace drydock::doctor {
namespace {

namespace port_fs = std::filesystem;

bool is_number(const std::string& text) {
  return std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::set<std::string> open_files(const port_fs::path& process) {
  std::set<std::string> files;
  std::error_code gone;
  for (const auto& fd : port_fs::directory_iterator(process / "fd", gone)) {
    std::error_code no_link;
    files.insert(port_fs::read_symlink(fd.path(), no_link).string());
  }
  return files;
}

/// A pty's maker has the other end of it open.
bool makes_ptys(const std::set<std::string>& files) {
  return files.contains("/dev/ptmx") || files.contains("/dev/pts/ptmx");
}

}  // namespace

std::string real_path(const std::string& root, const std::string& path) {
  std::error_code gone;
  const auto target = port_fs::read_symlink(root == "/" ? path : root + path, gone);
  if (gone) return path;
  return target.is_absolute() ? target.string() : "/dev/" + target.filename().string();
}

std::vector<Holder> holders_of(const std::string& root, const std::string& path) {
  const std::string port = real_path(root, path);
  const std::string self = root == "/" ? std::to_string(::getpid()) : std::string();
  std::vector<Holder> holders;
  std::error_code gone;
  for (const auto& entry : port_fs::directory_iterator(port_fs::path(root) / "proc", gone)) {
    const auto number = entry.path().filename().string();
    if (!is_number(number) || number == self) continue;
    const auto files = open_files(entry.path());
    if (!files.contains(port) || (port.starts_with("/dev/pts/") && makes_ptys(files))) continue;
    std::ifstream in(entry.path() / "comm");
    Holder holder{{}, number};
    std::getline(in, holder.name);
    holders.push_back(std::move(holder));
  }
  return holders;
}

std::string in_words(const std::vector<Holder>& holders) {
  std::string text;
  for (const auto& holder : holders)
    text += fmt::format("{}{} (process {})", text.empty() ? "" : ", ", holder.name, holder.process);
  return text;
}

}  // namespace drydock::doctor
