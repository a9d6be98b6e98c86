#include <cstdlib>

#include "hil/replay/reference/references.hpp"

/// Any text is refused with a line, or gives references. Writing and reading them again gives the
/// same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace drydock;
  const auto read = replay::parse_references({reinterpret_cast<const char*>(data), size});
  if (!read) {
    if (read.error().line.empty()) std::abort();
    return 0;
  }
  const std::string written = to_json_text(*read);
  const auto again = replay::parse_references(written);
  if (!again || to_json_text(*again) != written) std::abort();
  return 0;
}
