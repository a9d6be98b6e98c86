#include "hil/score/read_truth.hpp"

#include <fmt/format.h>

#include "drivers/recordings/record/recording.hpp"
#include "hil/replay/recorded_truth.hpp"
#include "hil/score/attitude.hpp"

namespace drydock::score {
namespace {

/// Keeps the truth that a recording tells.
class TruthKeeper final : public host::Follower {
 public:
  void on_truth(const host::Estimate& truth) override {
    if (!truth.navigation) return;
    const auto& n = *truth.navigation;
    const frame::Position at{n.latitude_rad, n.longitude_rad, n.height_m};
    if (kept.track.empty()) kept.origin = at;
    if (!kept.track.empty() && n.valid_at <= kept.track.back().at) return;  // of another estimator
    kept.track.push_back({.at = n.valid_at,
                          .position_ned = frame::ned_offset(kept.origin, at),
                          .angles = angles_of(n.body_to_ned),
                          .velocity = n.velocity_ned});
  }
  Truth kept;
};

}  // namespace

boost::system::result<Truth, Problem> read_truth(const std::string& path) {
  auto recording = record::Recording::open(path);
  if (!recording) return Problem{recording.error().line};
  TruthKeeper keeper;
  replay::RecordedTruth truth(keeper);
  while (const auto event = recording->next())
    if (const auto* message = std::get_if<record::Understood>(&*event)) truth.hear(*message);
  truth.tell();
  keeper.kept.damage = recording->damage();
  if (!keeper.kept.track.empty()) return keeper.kept;
  return Problem{fmt::format("{}: no truth in it; a run of an emulated rig records it", path)};
}

}  // namespace drydock::score
