#pragma once

#include <string>
#include <string_view>

namespace drydock::rig_config {

/// For a path that leads to no file: " (did you mean 'dive.toml'?)" where its folder, or for a bare
/// word also the shipped files, have nearly that name; for another bare word where the list of
/// shipped files is. Else an empty text.
std::string nearest_file(const std::string& path);

/// Why the file that a rig or mission names cannot be it, and what to do: a folder, a misspelt
/// name, or a shipped file of its kind (shipped.hpp; empty: none is shipped), which has to be
/// written beside it first. Precondition: it is no file.
std::string why_no_file(const std::string& path, std::string_view kind);

}  // namespace drydock::rig_config
