#pragma once

#include <vector>

#include "drivers/live/server.hpp"

namespace drydock::live {

/// The page that a browser gets: what stands in drivers/live/page, inside the program.
std::vector<PageFile> page_files();

}  // namespace drydock::live
