#pragma once

#include <cstdio>

#include "drivers/decode/decode.hpp"

namespace drydock::decode {

/// `drydock decode --pgns`: the messages of an NMEA 2000 capture as a table of PGNs describes them.
/// What the table does not have is counted by name. Exit code as for decode().
int decode_by_pgns(const DecodeOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::decode
