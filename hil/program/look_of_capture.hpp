#pragma once

#include <string>

namespace drydock::program {

/// Throws std::runtime_error with what to do where a file is of a kind that no command reads.
void must_be_no_foreign_file(const std::string& file);

/// For a file of bytes in which a protocol found nothing: a line on standard error with the
/// protocol that the bytes look like. No line, where they look like none or like that one.
void say_what_it_looks_like(const std::string& file, const std::string& protocol);

}  // namespace drydock::program
