#include "rig_config/file_trouble.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>

#include "drivers/wire/packed_content.hpp"

namespace drydock::rig_config {

namespace {

struct Sign {
  std::string_view magic, what;
};

constexpr std::array<Sign, 6> signs{{{"\x89MCAP", "an MCAP recording"},
                                     {"\x0A\x0D\x0D\x0A", "a pcapng capture"},
                                     {"\xD4\xC3\xB2\xA1", "a pcap capture"},
                                     {"\xA1\xB2\xC3\xD4", "a pcap capture"},
                                     {"\x4D\x3C\xB2\xA1", "a pcap capture"},
                                     {"\xA1\xB2\x3C\x4D", "a pcap capture"}}};

}  // namespace

std::string no_text_trouble(const std::string& path) {
  std::array<char, 512> head{};
  std::ifstream in(path, std::ios::binary);
  in.read(head.data(), head.size());
  const std::string_view text(head.data(), static_cast<std::size_t>(in.gcount()));
  const auto* found =
      std::ranges::find_if(signs, [&](const Sign& sign) { return text.starts_with(sign.magic); });
  if (found == signs.end() && text.find('\0') == text.npos) return "";
  return fmt::format("is {}, no TOML file: drydock info says what is in it",
                     found == signs.end() ? "a binary file" : found->what);
}

std::string file_trouble(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (error) return error.message();
  if (std::filesystem::is_directory(status)) return "is a folder, not a file";
  // Opening a pipe may wait for ever, and a device may never end.
  if (!std::filesystem::is_regular_file(status)) return "is a device or a pipe, not a file";
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::strerror(errno);
  std::array<char, 8> head{};
  in.read(head.data(), head.size());
  const auto packed = wire::packed_content({head.data(), static_cast<std::size_t>(in.gcount())});
  if (!packed.empty()) return std::string(packed);
  return std::filesystem::file_size(path, error) == 0 && !error ? "is empty" : "";
}

}  // namespace drydock::rig_config
