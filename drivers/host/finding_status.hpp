#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/bus/device.hpp"
#include "drivers/diagnosis/finding_account.hpp"

namespace drydock::host {

/// One status of `rt/diagnostics` for a finding: "dvl/damaged". Times are seconds of UTC since
/// 1970, so the account must count from Stamp{}. Its level is ok once the finding is over.
bus::DeviceStatus status_of(const diagnosis::FindingAccount& finding);

/// The reverse. Empty if it is not the status of a finding. Anybody can write anything to the bus:
/// text that is not a finite number gives 0.
std::optional<diagnosis::FindingAccount> finding_of(const bus::DeviceStatus& status);

/// The findings that last, as statuses: the bus tells them again each second, for those who came
/// later.
class FindingStatuses {
 public:
  /// By `Finding::device`.
  explicit FindingStatuses(std::vector<std::string> devices) : devices_(std::move(devices)) {}
  explicit FindingStatuses(const std::vector<bus::Device>& devices);

  bus::DeviceStatus take(const diagnosis::Finding& finding);
  std::span<const bus::DeviceStatus> open() const { return open_; }

 private:
  std::vector<std::string> devices_;
  std::vector<bus::DeviceStatus> open_;
};

}  // namespace drydock::host
