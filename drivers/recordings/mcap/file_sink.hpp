#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "drivers/recordings/mcap/file_writer.hpp"

namespace drydock::mcap {

/// A new file, as the sink of a writer. `path` must not exist, unless `overwrite`. Beside what
/// write() reports, a file that was deleted meanwhile is an error: nobody would ever find it.
boost::system::result<Sink> file_sink(const std::string& path, bool overwrite = false);

/// Why there is no such sink, in a line: "dive.mcap: File exists; --overwrite replaces it".
std::string refused(const std::string& path, const boost::system::error_code& error);

}  // namespace drydock::mcap
