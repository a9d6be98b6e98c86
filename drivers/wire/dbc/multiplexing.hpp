#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/dbc/remarks.hpp"

namespace drydock::wire::dbc {

/// When a signal is present, as the text says it.
struct Choice {
  std::optional<std::int64_t> value;  ///< N of mN
  std::string selector;               ///< of SG_MUL_VAL_; empty: the message's only M
  std::vector<Range> ranges;          ///< of SG_MUL_VAL_; they replace the value
};

/// Gives each signal of the message its selector and its values, and puts selectors before what
/// they select. `choices` belong to the signals, one to each.
void resolve_multiplexing(Message& message, const std::vector<Choice>& choices, Remarks& remarks);

/// False if two signals are selected by different values, so that no frame has both.
bool may_stand_together(const Message& message, const Signal& a, const Signal& b);

}  // namespace drydock::wire::dbc
