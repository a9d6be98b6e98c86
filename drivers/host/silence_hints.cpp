#include "drivers/host/silence_hints.hpp"

#include <fmt/format.h>

namespace drydock::host {

HintLines::HintLines(std::shared_ptr<SilenceHints> hints,
                     std::vector<const device::Device*> devices)
    : hints_(std::move(hints)), devices_(std::move(devices)) {
  for (const auto* device : devices_) hints_->add(*device);
}

void HintLines::on_finding(const diagnosis::Finding& finding) {
  if (!finding.until) due_.insert(finding.device);
}

std::vector<std::string> HintLines::news() {
  std::vector<std::string> lines;
  for (const std::size_t i : due_) {
    if (told_.contains(i)) continue;
    const auto hint = hints_->hint(*devices_.at(i));
    if (hint.empty()) continue;
    lines.push_back(fmt::format("{}: {}", devices_[i]->name(), hint));
    told_.insert(i);
  }
  return lines;
}

std::vector<std::string> HintLines::last() {
  for (std::size_t i = 0; i < devices_.size(); ++i) due_.insert(i);
  return news();
}

}  // namespace drydock::host
