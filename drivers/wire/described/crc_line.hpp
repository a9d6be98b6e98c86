#pragma once

#include <string>
#include <string_view>

#include "drivers/wire/described/crc_catalogue.hpp"

namespace drydock::wire::described {

/// Reads the parameters of a CRC as its catalogue writes them: "width=32 poly=0x04c11db7 init=0x0
/// refin=true refout=true xorout=0x0", perhaps with check=, residue= and name=. Numbers are
/// hexadecimal but for the width. Empty, or what is wrong; a `check` that the parameters do not
/// give is wrong too.
std::string read_crc(std::string_view line, Crc& into);

}  // namespace drydock::wire::described
