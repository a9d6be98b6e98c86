#include "hil/program/look_of_capture.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "drivers/link/uri.hpp"
#include "drivers/probe/probe_report.hpp"

namespace drydock::program {

void say_what_it_looks_like(const std::string& file, const std::string& protocol) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return;
  const auto heard = probe::find_sensors(link::file_uri(file) + "?speed=max", 0);
  if (heard.attempts.empty() || heard.attempts.back().findings.empty()) return;
  const auto& best = heard.attempts.back().findings.front();
  if (best.confidence < survey::Confidence::likely || best.protocol == protocol) return;
  fmt::print(stderr, "the bytes look like {}: drydock probe file:{} says more\n", best.protocol,
             file);
}

}  // namespace drydock::program
