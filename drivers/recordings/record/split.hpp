#pragma once

#include <boost/system/result.hpp>
#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::record {

/// How a recording is divided into files, and which of them stay. 0: without limit.
struct Split {
  std::uint64_t size = 0;             ///< bytes of a file
  std::chrono::nanoseconds every{0};  ///< time that a file covers
  std::uint64_t keep_size = 0;        ///< bytes of all files; the oldest are deleted
  std::chrono::nanoseconds keep_for{0};
  /// Time is that of the messages. Otherwise it is the steady clock's, which nobody sets.
  bool virtual_time = false;

  bool divides() const { return size > 0 || every.count() > 0; }
};

/// A file of a recording that was just made. Device and inode tell it from a later one of its name.
struct Part {
  mcap::Sink sink;
  std::string path{};
  std::uint64_t device = 0, inode = 0;
};

/// Makes the next file. It is called from the thread that writes.
using NextPart = std::function<boost::system::result<Part>()>;

/// Where a recording goes.
struct Parts {
  Part first;
  Split split{};
  NextPart next{};  ///< only for a recording that is divided
};

}  // namespace drydock::record
