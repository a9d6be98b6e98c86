#pragma once

#include <string>

namespace drydock::rig_config {

/// For a path that leads to no file: " (did you mean 'dive.toml'?)" where its folder, or for a bare
/// word also the shipped files, have nearly that name; for another bare word where the list of
/// shipped files is. Else an empty text.
std::string nearest_file(const std::string& path);

}  // namespace drydock::rig_config
