#pragma once

#include <cstdio>

#include "drivers/decode/decode.hpp"

namespace drydock::decode {

/// `drydock decode --dbc`: the frames of a CAN capture as messages of a DBC file. A frame without a
/// message there is counted by its identifier. Exit code as for decode().
int decode_by_dbc(const DecodeOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::decode
