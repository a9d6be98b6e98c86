#pragma once

#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/record/split.hpp"

namespace drydock::record {

/// Makes the files of a divided recording: `dive.mcap` gives dive-0001.mcap, dive-0002.mcap and so
/// on. It goes on behind the highest number that is there, so it never replaces a file.
class PartFiles {
 public:
  PartFiles(std::string path, mcap::Sync sync);

  boost::system::result<Part> next();
  /// The path of the file that next() tries first.
  std::string next_path() const { return path_of(number_ + 1); }

 private:
  std::string path_of(std::uint64_t number) const;

  std::string path_;
  mcap::Sync sync_;
  std::uint64_t number_ = 0;  ///< of the newest file
};

}  // namespace drydock::record
