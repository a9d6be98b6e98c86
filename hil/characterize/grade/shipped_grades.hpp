#pragma once

#include <span>
#include <string_view>

namespace drydock::characterize {

/// The files of `rig_config/sensors` at the time of the build.
struct ShippedFile {
  std::string_view name, text;
};
std::span<const ShippedFile> shipped_files();

}  // namespace drydock::characterize
