#include "hil/program/look_of_capture.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>

#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/foreign_content.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/probe/probe_report.hpp"

namespace drydock::program {

void must_be_no_foreign_file(const std::string& file) {
  std::error_code error;  // a look takes bytes out of a pipe
  if (!std::filesystem::is_regular_file(file, error)) return;
  capture::FileBlocks blocks(file);
  const auto head = blocks.read();
  if (capture::is_measurement_data(head))
    throw std::runtime_error(fmt::format("{}: {}", file, capture::foreign_content(head)));
}

void say_what_it_looks_like(const std::string& file, const std::string& protocol) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return;
  if (std::filesystem::file_size(file, error) == 0) {
    fmt::print(stderr, "{} is empty\n", file);
    return;
  }
  const auto heard = probe::find_sensors(link::file_uri(file) + "?speed=max", 0);
  if (heard.attempts.empty() || heard.attempts.back().findings.empty()) return;
  const auto& best = heard.attempts.back().findings.front();
  if (best.confidence < survey::Confidence::likely || best.protocol == protocol) return;
  fmt::print(stderr, "the bytes look like {}: drydock probe file:{} says more\n", best.protocol,
             file);
}

}  // namespace drydock::program
