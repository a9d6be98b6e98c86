#pragma once

#include <span>
#include <string_view>

namespace drydock::characterize {

/// `rig_config/sensors` as the program was built.
struct ShippedFile {
  std::string_view name, text;
};
std::span<const ShippedFile> shipped_files();

}  // namespace drydock::characterize
