#pragma once

#include <optional>
#include <string>

#include "drivers/guess/line_form.hpp"

/// Lines of one form as a message of a description: a pattern with a group for each number.
namespace drydock::guess {

/// The text with which all of them begin, as the key `head` takes it.
std::string head_of(const LineForm& form);

/// `number`: of the message; `point`: what is before a fraction. Nothing if the pattern is too long
/// for a description.
std::optional<std::string> form_text(const LineForm& form, std::size_t number, char point);

}  // namespace drydock::guess
