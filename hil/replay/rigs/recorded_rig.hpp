#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// The rig of a recording. The constructor writes the attached rig file and the files that it names
/// into a temporary folder, with their relative paths, and reads them there. Links are those of the
/// recorded run. The destructor removes the folder.
class RecordedRig {
 public:
  /// Throws std::runtime_error with one line if even the devices cannot be read. If files are
  /// missing that only estimators need, the rig has devices only and `trouble()` says why.
  explicit RecordedRig(const record::Recording& recording);
  ~RecordedRig();
  RecordedRig(const RecordedRig&) = delete;
  RecordedRig& operator=(const RecordedRig&) = delete;

  const rig_config::Rig& rig() const { return rig_; }
  const std::string& trouble() const { return trouble_; }  ///< one line; empty: nothing is missing
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path write_out(const std::vector<mcap::Attachment>& attachments);
  void name_links(const record::Recording& recording);

  std::filesystem::path folder_;
  rig_config::Rig rig_;
  std::string trouble_;
};

}  // namespace drydock::replay
