#pragma once

#include <string>
#include <vector>

/// Orders that `drydock fault` and a page send to a running bench, as one line of JSON:
/// docs/use/faults.md, Live.
namespace drydock::control {

/// The `[[fault]]` table of a device from typed pairs: "probability=0.5", "velocity_mps=0.5,0,0".
/// Throws std::runtime_error with one line if a pair is not KEY=VALUE.
std::string fault_table(const std::string& device, const std::string& fault,
                        const std::vector<std::string>& pairs, double for_s);

std::string order_to_set(const std::string& table);
/// An empty device or fault means all.
std::string order_to_clear(const std::string& device, const std::string& fault);
std::string order_to_list();

}  // namespace drydock::control
