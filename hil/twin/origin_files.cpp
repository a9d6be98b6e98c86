#include "hil/twin/origin_files.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "drivers/recordings/record/recording.hpp"
#include "hil/replay/replay_rig.hpp"
#include "hil/replay/rigs/recorded_rig.hpp"
#include "hil/report/write_file.hpp"
#include "hil/track/capture_rig.hpp"
#include "rig_config/load.hpp"

namespace drydock::twin {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path.string() + ": cannot be read");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The motion is that of the track, and the errors of sensors are measured: only files of
/// estimators and descriptions are needed.
RigOrigin copied(const rig_config::Rig& rig, const std::string& folder) {
  RigOrigin origin{content_of(rig.file), fs::path(rig.file).parent_path().string(), {}};
  for (std::size_t i = 1; i < rig.files.size(); ++i) {
    const fs::path path = fs::path(rig.files[i]).lexically_normal();
    const auto name = "files/" + path.filename().string();
    report::write_file(fs::path(folder) / name, content_of(path));
    origin.files[path.string()] = name;
  }
  return origin;
}

RigOrigin of_capture(const track::TrackOptions& source, measurement::Kind kind,
                     const std::string& folder) {
  rig_config::DeviceConfig device;
  device.name = std::string(to_string(kind));
  device.kind = kind;
  device.protocol = source.source.protocol;
  device.address = source.source.address;
  RigOrigin origin{track::capture_rig_text(device, source.source.baud), ".", {}};
  if (!fs::exists(device.protocol)) return origin;
  const fs::path path = fs::path(device.protocol).lexically_normal();
  const auto name = "files/" + path.filename().string();
  report::write_file(fs::path(folder) / name, content_of(path));
  origin.files[path.string()] = name;
  return origin;
}

}  // namespace

RigOrigin copy_rig_of(const track::TrackOptions& source, measurement::Kind capture_kind,
                      const std::string& folder) {
  if (!source.rig.empty()) return copied(rig_config::load_rig(source.rig).value(), folder);
  if (!replay::is_recording(source.source.capture)) return of_capture(source, capture_kind, folder);
  auto recording = record::Recording::open(source.source.capture);
  if (!recording) throw std::runtime_error(recording.error().line);
  const replay::RecordedRig recorded(*recording);
  if (!recorded.trouble().empty())
    throw std::runtime_error(recorded.trouble() + "; --rig names a rig file that is whole");
  return copied(recorded.rig(), folder);
}

}  // namespace drydock::twin
