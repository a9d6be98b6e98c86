#include "hil/replay/rigs/recorded_rig.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "drivers/recordings/record/player.hpp"
#include "rig_config/load.hpp"

namespace drydock::replay {

namespace {

namespace fs = std::filesystem;

constexpr const char* rig_name = "rig.toml";

fs::path make_folder() {
  std::string name = (fs::temp_directory_path() / "drydock-replay-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    throw std::runtime_error("cannot make a folder in " + fs::temp_directory_path().string());
  return name;
}

/// The number of folders that a relative path goes up before it goes down.
int climbs(const fs::path& path) {
  const auto normal = path.lexically_normal();
  return static_cast<int>(std::count(normal.begin(), normal.end(), fs::path("..")));
}

}  // namespace

RecordedRig::RecordedRig(const record::Recording& recording) : folder_(make_folder()) {
  try {
    if (auto whole = rig_config::load_rig(write_out(recording.attachments()).string())) {
      rig_ = std::move(*whole);
      name_links(recording);
      return;
    } else if (!whole.error().empty()) {
      trouble_ = whole.error().front().what;
    }
    auto devices = record::rig_of(recording);
    if (!devices) throw std::runtime_error(devices.error().line);
    rig_ = std::move(*devices);
    trouble_ = rig_.estimators.empty() ? "" : "drivers only, without the estimators: " + trouble_;
    rig_.estimators.clear();
    name_links(recording);
  } catch (...) {
    fs::remove_all(folder_);
    throw;
  }
}

/// A relative `file:` link would mean a file in the temporary folder.
void RecordedRig::name_links(const record::Recording& recording) {
  for (const auto& link : recording.links())
    for (auto& device : rig_.devices)
      if (std::ranges::find(link.devices, device.name) != link.devices.end())
        device.link = link.uri;
}

RecordedRig::~RecordedRig() {
  std::error_code ignored;  // the system clears temporary files that cannot be removed here
  fs::remove_all(folder_, ignored);
}

/// Attachments come from other people. None may lie outside the folder, even if its path contains
/// "..".
std::filesystem::path RecordedRig::write_out(const std::vector<mcap::Attachment>& attachments) {
  int depth = 0;
  for (const auto& attachment : attachments) depth = std::max(depth, climbs(attachment.name));
  fs::path beside = folder_;
  for (int i = 0; i < depth; ++i) beside /= fmt::format("{}", i);
  fs::create_directories(beside);
  for (const auto& attachment : attachments) {
    if (fs::path(attachment.name).is_absolute()) continue;
    const auto path = (beside / attachment.name).lexically_normal();
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << attachment.data;
  }
  return beside / rig_name;
}

}  // namespace drydock::replay
