#pragma once

#include <istream>
#include <string>

namespace drydock::score {

/// What a file of text is by its first line that is no comment: "gpx", "tum" (8 numbers), "kitti"
/// (12 numbers) or "csv". The file is read from its beginning afterwards.
std::string format_of_text(std::istream& in);

}  // namespace drydock::score
