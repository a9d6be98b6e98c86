#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hil/fault/injector.hpp"

/// What `drydock fault` asks of a running bench, as one line of JSON each way: docs/faults.md,
/// Live.
namespace drydock::cli {

/// `[[fault]]` of a device with what was typed: "probability=0.5", "velocity_mps=0.5,0,0".
/// Throws std::runtime_error with a line where that is no KEY=VALUE.
std::string fault_table(const std::string& device, const std::string& fault,
                        const std::vector<std::string>& pairs, double for_s);

std::string order_to_set(const std::string& table);
/// Of all devices, or all faults, where the text is empty.
std::string order_to_clear(const std::string& device, const std::string& fault);
std::string order_to_list();

/// Does what a line asks and says what became of it:
/// {"ok":true,"lines":[...],"faults":[{"device","words","since_s","until_s"}]}. A line that is no
/// order, or that cannot be obeyed, changes nothing: {"ok":false,"lines":[why]}.
std::string obey(std::string_view request, const rig_config::Rig& rig, fault::Injector& injector,
                 measurement::Stamp start, measurement::Stamp now);

}  // namespace drydock::cli
