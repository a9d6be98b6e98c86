#pragma once

#include <string>

namespace drydock::link {

/// Makes the folder for its owner alone, if it is missing. Empty if it is this user's own and
/// nobody else may put names into it; otherwise one line that says what to do. Under /tmp anybody
/// may have made it, or put a symbolic link in its place.
std::string make_private_folder(const std::string& folder);

}  // namespace drydock::link
