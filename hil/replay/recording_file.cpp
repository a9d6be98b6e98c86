#include "hil/replay/recording_file.hpp"

#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "drivers/recordings/record/recording.hpp"

namespace drydock::replay {

bool is_recording(const std::string& path) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(path, none)) return false;
  std::array<char, mcap::magic.size()> head{};
  std::ifstream in(path, std::ios::binary);
  return in.read(head.data(), head.size()) &&
         std::memcmp(head.data(), mcap::magic.data(), head.size()) == 0;
}

}  // namespace drydock::replay
