#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

/// The files that come with the program: in its source tree where it was built, else where its
/// package has them.
namespace drydock::rig_config {

/// Their kinds, each a folder.
inline constexpr std::string_view rigs = "rigs", missions = "missions", sensors = "sensors",
                                  vehicles = "vehicles", devices = "devices",
                                  campaigns = "campaigns", starts = "starts";

/// Those that a person names, each once; a name may be in several.
inline constexpr std::array kinds_of_files{rigs, missions, sensors, vehicles, devices, campaigns};

/// The folder that holds rig_config: a folder above the program, or share/drydock beside one; else
/// so of the library that this code is in. Empty: there is none.
std::filesystem::path shipped_folder();

/// The shipped files of a kind, sorted.
std::vector<std::filesystem::path> shipped_files(std::string_view kind);

/// The file that a word on a command line means: that file, or the one with the ending .toml, if
/// there is one; else a shipped one of the kind, with or without its ending (`demo`), or by its
/// path in the tree. Else the word itself.
std::string find_shipped(const std::string& word, std::string_view kind);

}  // namespace drydock::rig_config
