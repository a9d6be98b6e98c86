#pragma once

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The bus behind `listen=1`: it reads, and refuses every write with an error that names the key.
std::unique_ptr<FrameLink> make_listening(std::unique_ptr<FrameLink> bus);

}  // namespace drydock::link
