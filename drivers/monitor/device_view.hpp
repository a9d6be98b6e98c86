#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drivers/device/health_account.hpp"
#include "drivers/diagnosis/finding_account.hpp"
#include "drivers/monitor/values/shown_value.hpp"

namespace drydock::monitor {

/// One device in the display of a monitor or a run.
struct DeviceView : device::HealthAccount {
  bool streaming = false;
  std::optional<double> bus_load;  ///< on a CAN bus: share of its bit rate, 0 to 1
  std::optional<double> bits_per_second;
  std::string can_state;  ///< state of the CAN controller; empty: not known
  /// Time of validity and arrival are separate; their difference is the latency.
  std::optional<double> valid_at_s, received_at_s, device_time_s, latency_s;
  std::optional<diagnosis::FindingAccount> finding;  ///< what is wrong now; times are UTC
  std::vector<ShownValue> values;
  std::string hint;         ///< why it is silent, by what its wire says; empty: not known
  std::string told;         ///< what hosts have told an emulated device; empty: nothing
  std::string shared_with;  ///< programs that read its port too; empty: none
};

}  // namespace drydock::monitor
