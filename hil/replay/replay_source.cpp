#include "hil/replay/replay_source.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "hil/replay/rigs/captured_recording.hpp"
#include "hil/replay/rigs/laid_capture.hpp"
#include "rig_config/load.hpp"

namespace drydock::replay {

rig_config::Rig rig_in(const std::string& file) {
  auto loaded = rig_config::load_rig(file);
  if (!loaded) throw std::runtime_error(to_string(loaded.error().front()));
  return std::move(*loaded);
}

ReplaySource source_of(const RigReplayOptions& options) {
  if (options.captures.files.empty()) {
    auto recording = record::Recording::open(options.recording);
    if (!recording) throw std::runtime_error(recording.error().line);
    return {.recording = std::move(*recording)};
  }
  auto laid = lay(rig_in(options.rig), options.captures);
  auto made = record_capture(laid.rig);
  std::ranges::move(made.notes, std::back_inserter(laid.notes));
  return {std::move(made.recording), std::move(laid), std::move(made.ends)};
}

}  // namespace drydock::replay
