#include "hil/replay/replay_account.hpp"

#include <fmt/format.h>

namespace drydock::replay {

namespace {

std::string error_text(const TruthErrors::Rms& rms) {
  if (rms.attitudes == 0) return "";
  std::string text = fmt::format("; against the recorded truth: roll {:.3f} deg, pitch {:.3f} deg",
                                 rms.roll_deg, rms.pitch_deg);
  if (rms.positions > 0) text += fmt::format(", horizontal {:.2f} m", rms.horizontal_m);
  return text + fmt::format(" RMS of {}", rms.attitudes);
}

}  // namespace

void print_account(std::FILE* to, const rig_config::Rig& rig, const ReplayBench& bench) {
  for (const auto& actor : bench.player().devices()) {
    const auto& device = actor->device();
    const auto health = device.health(bench.player().now());
    fmt::print(to, "{}: {} measurements, {} frames, {} bad checksums, {} bytes skipped\n",
               device.name(), health.messages, health.stream.frames, health.stream.bad_checksums,
               health.stream.bytes_skipped);
  }
  if (const auto* faults = bench.faults())
    for (const auto& line : faults->lines()) fmt::print(to, "{}\n", line);
  for (std::size_t i = 0; i < rig.estimators.size(); ++i)
    fmt::print(to, "{}: {} estimates{}\n", rig.estimators[i].name, bench.estimates()[i],
               error_text(bench.errors().of(i)));
}

void print_length(std::FILE* to, const record::Selection& part, const ReplayBench& bench) {
  if (part.from && measurement::seconds(bench.played()) == 0)
    fmt::print(to, "the recording ends before --from {:g} s; drydock info tells its length\n",
               measurement::seconds(*part.from));
  fmt::print(to, "{:.1f} s{}\n", measurement::seconds(bench.played()),
             bench.interrupted() ? ", ended early" : "");
}

}  // namespace drydock::replay
