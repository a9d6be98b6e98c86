#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <regex>
#include <sstream>

#include "drivers/link/uri.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "hil/bench/run.hpp"
#include "hil/check/check.hpp"
#include "rig_config/load.hpp"
#include "tests/drivers/decode/captured.hpp"
#include "tests/hil/check/mutated_rig.hpp"

/// The promise of `drydock check`: a rig that it accepts starts, and a refusal says where.
namespace drydock::check {
namespace accepted_rigs_start_test {

using decode::MemoryFile;

/// Empty if the rig starts: in virtual time where it can, else its drivers alone.
std::string why_it_does_not_start(const rig_config::Rig& rig) try {
  const auto has_virtual_time = [](const rig_config::DeviceConfig& device) {
    const auto uri = link::parse_uri(device.link);
    return uri && (uri->emulated() || uri->recorded());
  };
  if (!std::ranges::all_of(rig.devices, has_virtual_time)) {
    const auto drivers = shell::make_devices(rig);
    return drivers ? "" : drivers.error().message;
  }
  bench::RunOptions options;
  options.duration_s = 0.2;
  options.lockstep = options.quiet = true;
  bench::run_lockstep(rig, options);
  return {};
} catch (const std::exception& error) {
  return error.what();
}

struct Verdict {
  int exit_code = 0;
  std::vector<std::string> lines;
};

Verdict checked(const std::string& path) {
  MemoryFile out;
  Verdict verdict{check({path}, out.file()), {}};
  std::istringstream text(out.text());
  for (std::string line; std::getline(text, line);) verdict.lines.push_back(line);
  return verdict;
}

void accepted_starts_and_refused_says_where(const std::vector<std::string>& rigs) {
  static const RigFolder folder;
  static const std::regex problem("[^:]+:[0-9]+:[0-9]+: /[^: ]*: .+");
  const std::string path = write_mutated(folder, rigs);
  const Verdict verdict = checked(path);
  RC_CLASSIFY(verdict.exit_code == 0, "accepted");
  RC_LOG() << decode::read_file(path);
  if (verdict.exit_code == 0) {
    const auto rig = rig_config::load_rig(path, load_options());
    RC_ASSERT(rig.has_value());
    const std::string refused = why_it_does_not_start(*rig);
    RC_LOG() << "check says ok, the start says " << refused << "\n";
    RC_ASSERT(refused.empty());
    return;
  }
  RC_ASSERT(verdict.exit_code == 2);
  RC_ASSERT(!verdict.lines.empty());
  for (const auto& line : verdict.lines) {
    RC_LOG() << line << "\n";
    RC_ASSERT(std::regex_match(line, problem));
  }
}

RC_GTEST_PROP(AcceptedRigsStart, AShippedRigWithOneOrTwoChanges, ()) {
  accepted_starts_and_refused_says_where({"demo.toml", "every-protocol.toml", "every-protocol.toml",
                                          "bench-serial.toml", "forty.toml", "mixing-paper.toml",
                                          "shelf.toml", "soak.toml", "sounding-rocket.toml",
                                          "velocity-paper.toml"});
}

}  // namespace accepted_rigs_start_test
}  // namespace drydock::check
