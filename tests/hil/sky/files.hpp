#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "hil/sky/gps_time.hpp"

namespace drydock::sky::test {

inline std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::filesystem::path walker(const std::string& ending = "rnx") {
  return DRYDOCK_SOURCE_DIR "/fixtures/rinex/walker." + ending;
}

/// Folder with files of other producers. It may be missing.
inline std::filesystem::path gnss_corpus() {
  const char* folder = std::getenv("DRYDOCK_CORPORA");
  return std::filesystem::path(folder ? folder : DRYDOCK_SOURCE_DIR "/../shared/corpora") / "gnss";
}

/// The toe of walker.rnx.
constexpr GpsTime walker_toe{std::chrono::sys_days{std::chrono::year{2026} / 11 / 21} -
                             std::chrono::sys_days{std::chrono::year{1980} / 1 / 6} +
                             std::chrono::hours{10}};

}  // namespace drydock::sky::test
