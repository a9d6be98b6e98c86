#pragma once

#include <cstdlib>
#include <filesystem>

namespace drydock::navigation::test {

/// The folder of the recordings, which are not in this tree.
inline std::filesystem::path ins() {
  const char* named = std::getenv("DRYDOCK_CORPORA");
  return std::filesystem::path{named ? named : DRYDOCK_SOURCE_DIR "/../shared/corpora"} / "ins";
}

}  // namespace drydock::navigation::test
