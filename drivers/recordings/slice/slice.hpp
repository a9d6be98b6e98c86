#pragma once

#include "drivers/recordings/record/selection.hpp"
#include "drivers/recordings/slice/disguise.hpp"

/// Cuts parts from recordings, to send to others.
namespace drydock::slice {

struct SliceOptions {
  record::Selection part;
  std::chrono::nanoseconds shift_time{};
  std::optional<Stamp> start_at;                 ///< shifts the time so that the slice begins then
  std::optional<measurement::Geodetic> move_to;  ///< new place of the slice's first position
  bool overwrite = false;
};

struct Sliced {
  std::uint64_t messages = 0, moved = 0;
  std::optional<Stamp> first, last;  ///< log times in the slice
  Dropped dropped;
  std::chrono::nanoseconds shift{};
  bool ended_early = false;  ///< the watch ended it
  std::string damage;        ///< of the recording; empty: none
};

/// Copies a part of a recording into a new file, with all channels, attachments and metadata.
boost::system::result<Sliced, record::RecordingError> slice(const std::string& recording,
                                                            const std::string& to,
                                                            const SliceOptions& options,
                                                            const record::Watch& watch);

}  // namespace drydock::slice
