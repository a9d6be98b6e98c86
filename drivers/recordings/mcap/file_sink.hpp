#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::mcap {

/// A new file as the sink of a writer. `path` must not exist, unless `overwrite`. The sink reports
/// the errors of write(). It also reports an error if the file was deleted in the meantime, because
/// nobody could ever find it.
boost::system::result<Sink> file_sink(const std::string& path, bool overwrite = false);

/// One line that says why the sink could not be made: "dive.mcap: File exists; --overwrite replaces
/// it".
std::string refused(const std::string& path, const boost::system::error_code& error);

}  // namespace drydock::mcap
