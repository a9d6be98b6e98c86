#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::mcap {

/// Whether a write ends only when the disk has the bytes, so that they survive a pulled plug. On
/// ext4, XFS and Btrfs they do. FAT and exFAT keep no journal: a file that grew may need fsck.
enum class Sync : std::uint8_t { never, each_write };

/// A new file as the sink of a writer. `path` must not exist, unless `overwrite`, and then it must
/// be no symbolic link to a file. The sink reports
/// the errors of write(). It also reports an error if the file was deleted in the meantime, because
/// nobody could ever find it. With Sync::each_write the folder too is on the disk when this
/// returns.
boost::system::result<Sink> file_sink(const std::string& path, bool overwrite = false,
                                      Sync sync = Sync::never);

/// One line that says why the sink could not be made: "dive.mcap: File exists; --overwrite replaces
/// it".
std::string refused(const std::string& path, const boost::system::error_code& error);

}  // namespace drydock::mcap
