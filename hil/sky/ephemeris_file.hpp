#pragma once

#include <boost/system/result.hpp>
#include <string>

#include "hil/sky/rinex.hpp"

namespace drydock::sky {

/// `file:line: what is wrong, what is allowed`; no line number if the file cannot be read.
struct FileError {
  std::string message;
};

/// Called by result::value() if there is no file; throws std::runtime_error.
[[noreturn]] void throw_exception_from_error(const FileError& error,
                                             const boost::source_location& where);

/// A RINEX navigation file with at least one GPS record.
boost::system::result<Navigation, FileError> read_navigation_file(const std::string& path);

}  // namespace drydock::sky
