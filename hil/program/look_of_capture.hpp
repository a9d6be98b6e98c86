#pragma once

#include <string>

namespace drydock::program {

/// For a file of bytes in which a protocol found nothing: a line on standard error with the
/// protocol that the bytes look like. No line, where they look like none or like that one.
void say_what_it_looks_like(const std::string& file, const std::string& protocol);

}  // namespace drydock::program
