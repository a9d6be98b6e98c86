#pragma once

#include "drivers/recordings/mcap/file_writer.hpp"
#include "drivers/recordings/mcap/reader.hpp"

namespace drydock::record {

struct Recovered {
  std::uint64_t messages = 0, attachments = 0;
  std::uint64_t first_time = 0, last_time = 0;  ///< ns since 1970
  std::string damage;                           ///< of the source; empty: none
  boost::system::error_code error;              ///< of the new file
};

/// Copies everything that can be read into a new file with a summary. The result is a complete
/// recording again. The source may come from any program.
Recovered recover(mcap::Reader& source, mcap::Sink sink);

}  // namespace drydock::record
