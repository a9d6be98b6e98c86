#pragma once

#include <string>

namespace drydock::link {

/// What a person does who may not open the port: joins its group, or gives it to one if it is for
/// root alone. Nobody needs the group root, which would give away the machine.
std::string access_advice(const std::string& path);

}  // namespace drydock::link
