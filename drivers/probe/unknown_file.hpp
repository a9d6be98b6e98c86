#pragma once

#include <string>

namespace drydock::probe {

/// What a person can do with a file of bytes in which no protocol was found. `raw`: it is read to
/// the byte.
std::string what_it_may_be(const std::string& file, bool raw);

}  // namespace drydock::probe
