#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "hil/pilot/loop_account.hpp"

/// How a loop over the wires went, for a person and for scripts.
namespace drydock::summary {

std::string loop_text(const pilot::LoopAccount& loop);  ///< for a terminal; ends with a newline
nlohmann::ordered_json loop_json(const pilot::LoopAccount& loop);
std::string loop_section(const pilot::LoopAccount& loop);  ///< of the page

}  // namespace drydock::summary
