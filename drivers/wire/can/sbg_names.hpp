#pragma once

#include <cstdint>
#include <string_view>

namespace drydock::wire::sbg {

/// What the maker's DBC file calls the message of this identifier, as delivered, without
/// SBG_ECAN_MSG_: "STATUS_01". Empty: it has none.
std::string_view message_name(std::uint32_t id);

}  // namespace drydock::wire::sbg
