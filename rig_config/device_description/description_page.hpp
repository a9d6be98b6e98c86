#pragma once

#include <string>

#include "drivers/wire/described/description.hpp"

namespace drydock::rig_config {

/// A page in Markdown about a described sensor: what it says, field by field, and what is said to
/// it. For people: it allocates.
std::string description_page(const wire::described::Description& description);

}  // namespace drydock::rig_config
