#pragma once

#include <vector>

#include "drivers/live/server.hpp"

namespace drydock::live {

/// The files of the page in drivers/live/page. The program contains them.
std::vector<PageFile> page_files();

}  // namespace drydock::live
