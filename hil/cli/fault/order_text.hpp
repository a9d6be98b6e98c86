#pragma once

#include <string>
#include <vector>

/// What `drydock fault`, and a page, ask of a running bench, as one line of JSON:
/// docs/use/faults.md, Live.
namespace drydock::cli {

/// `[[fault]]` of a device with what was typed: "probability=0.5", "velocity_mps=0.5,0,0".
/// Throws std::runtime_error with a line where that is no KEY=VALUE.
std::string fault_table(const std::string& device, const std::string& fault,
                        const std::vector<std::string>& pairs, double for_s);

std::string order_to_set(const std::string& table);
/// Of all devices, or all faults, where the text is empty.
std::string order_to_clear(const std::string& device, const std::string& fault);
std::string order_to_list();

}  // namespace drydock::cli
