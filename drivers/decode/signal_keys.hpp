#pragma once

#include <string>
#include <vector>

#include "drivers/wire/dbc/database.hpp"

namespace drydock::decode {

/// The JSON keys of a signal.
struct SignalKeys {
  std::string number;
  std::string label;  ///< empty: its values have no names
};

/// Of the signals of a message, in their order, each key once. A signal whose name is one of
/// decode's own keys has `device_` in front; a second one of the same name has `_2` behind.
std::vector<SignalKeys> keys_of(const wire::dbc::Message& message);

}  // namespace drydock::decode
