#pragma once

#include <functional>

#include "drivers/recordings/mcap/file_writer.hpp"
#include "drivers/recordings/mcap/reader.hpp"

namespace drydock::record {

struct Recovered {
  std::uint64_t messages = 0, attachments = 0;
  std::uint64_t first_time = 0, last_time = 0;  ///< ns since 1970
  std::uint64_t nameless = 0;                   ///< messages left out: their channel is lost
  std::string damage;                           ///< of the source; empty: none
  boost::system::error_code error;              ///< of the new file
  bool ended_early = false;                     ///< it was not to go on
};

/// Copies everything that can be read into a new file with a summary. The result is a complete
/// recording again. The source may come from any program. It is asked after each record
/// whether to go on; what was read until then is a complete recording too.
Recovered recover(
    mcap::Reader& source, mcap::Sink sink,
    const std::function<bool()>& go_on = [] { return true; });

}  // namespace drydock::record
