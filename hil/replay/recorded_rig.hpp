#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"
#include "rig_config/rig.hpp"

namespace drydock::replay {

/// The rig file of a recording and the files it names, written out of the attachments into a
/// temporary folder as they lay beside each other, and read from there. The folder lives as long.
class RecordedRig {
 public:
  /// Throws std::runtime_error with one line when not even the devices can be read. Where files
  /// are missing that estimators need, the rig has devices only and `trouble()` says why.
  explicit RecordedRig(const record::Recording& recording);
  ~RecordedRig();
  RecordedRig(const RecordedRig&) = delete;
  RecordedRig& operator=(const RecordedRig&) = delete;

  const rig_config::Rig& rig() const { return rig_; }
  const std::string& trouble() const { return trouble_; }  ///< a line; empty: all is there
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path write_out(const std::vector<mcap::Attachment>& attachments);

  std::filesystem::path folder_;
  rig_config::Rig rig_;
  std::string trouble_;
};

}  // namespace drydock::replay
