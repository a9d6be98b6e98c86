#pragma once

#include <optional>
#include <span>
#include <vector>

#include "drivers/wire/dbc/database.hpp"

namespace drydock::wire::dbc {

/// Two messages of which no frame tells which one it is: the same identifier; of J1939 the same
/// parameter group, sender and destination, whatever the priority. A file's sender FEh is any, and
/// then the destination tells nothing either.
struct SameFrame {
  std::size_t first = 0, second = 0;  ///< places of messages
};

/// Each message with the first one that has its frames.
std::vector<SameFrame> same_frames(std::span<const Message> messages);

}  // namespace drydock::wire::dbc
