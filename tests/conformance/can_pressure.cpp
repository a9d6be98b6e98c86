#include <regex>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/frame_vectors.hpp"

/// CiA 404 pressure transmitters. The frames come from the makers' manuals; words give their
/// meaning, "= 100000" for the process value and "status = 0".
namespace drydock::conformance {

namespace {

std::optional<double> number_behind(const std::string& words, const char* pattern) {
  std::smatch found;
  if (!std::regex_search(words, found, std::regex(pattern))) return {};
  return std::stod(found[1]);
}

}  // namespace

std::vector<Case> discover_can_pressure(const fs::path& folder) {
  return frame_vector_files(folder);
}

void compare_can_pressure(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  for (const FrameVector& vector : read_frame_vectors(one.capture)) {
    const auto integer = number_behind(vector.words, R"(i32 = (-?\d+))");
    const auto status = number_behind(vector.words, R"(status = (\d+))");
    if (!integer) continue;  // a mapping or a length in words, not a frame
    const auto decoded = decode_bytes("cia404-pressure", candump_line(vector)).messages;
    if (decoded.empty()) {
      score.missed(name, vector.line, vector.words);
      continue;
    }
    Comparison c(name, vector.line);
    c.number("process value", decoded[0]["integer"], *integer, {1});
    c.number("status", decoded[0]["status"], optional(status), {1});
    score.add(c);
  }
}

}  // namespace drydock::conformance
