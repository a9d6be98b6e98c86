#pragma once

#include <span>
#include <string>
#include <string_view>

namespace drydock::rig_config {

/// The known name of that for which `lower` is another word of the trade: gnss of "gps". Null:
/// none.
const std::string* other_name_of(std::string_view lower, std::span<const std::string> known);

}  // namespace drydock::rig_config
