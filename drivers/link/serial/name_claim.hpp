#pragma once

#include <string>

#include "drivers/link/descriptor.hpp"
#include "drivers/link/opening.hpp"

namespace drydock::link {

/// Claims a path for as long as the descriptor is open, so that a second program cannot take the
/// name of a device that lives. The kernel keeps the claim, as an abstract socket, and a crash
/// leaves nothing behind. It holds within one network namespace.
boost::system::result<Descriptor, OpenError> claim_name(const std::string& path);

}  // namespace drydock::link
