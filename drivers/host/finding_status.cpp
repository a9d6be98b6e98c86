#include "drivers/host/finding_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "drivers/diagnosis/finding_words.hpp"

namespace drydock::host {
namespace {

using diagnosis::EvidenceAccount;
using diagnosis::FindingAccount;
using Values = std::vector<std::pair<std::string, std::string>>;

std::string as_value(const std::string& text) { return text; }
std::string as_value(bool truth) { return truth ? "true" : "false"; }
std::string as_value(double number) { return fmt::format("{}", number); }
std::string as_value(const std::optional<double>& time_s) {
  return time_s ? fmt::format("{:.6f}", *time_s) : "";
}

/// "evidence_2_limit": the keys of one number that speaks for the finding.
std::string evidence_key(std::size_t index, const char* key) {
  return fmt::format("evidence_{}_{}", index + 1, key);
}

void add_evidence(const std::vector<EvidenceAccount>& evidence, Values& values) {
  for (std::size_t i = 0; i < evidence.size(); ++i)
    visit_fields(evidence[i], [&](const char* key, const auto& value) {
      values.emplace_back(evidence_key(i, key), as_value(value));
    });
}

Values values_of(const FindingAccount& finding) {
  Values values;
  visit_fields(finding, [&](std::string_view key, const auto& value) {
    if constexpr (requires { as_value(value); }) {
      if (key != "device" && key != "cause") values.emplace_back(key, as_value(value));
    } else {
      add_evidence(value, values);
    }
  });
  return values;
}

std::string message_of(const FindingAccount& finding) {
  if (finding.until_s) return "no longer " + finding.cause;
  const std::string evidence = diagnosis::evidence_text(finding);
  return evidence.empty() ? finding.meaning : finding.meaning + ": " + evidence;
}

std::optional<double> number_in(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc{} && end == text.data() + text.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

void take_value(const std::string& text, std::string& into) { into = text; }
void take_value(const std::string& text, bool& into) { into = text == "true"; }
void take_value(const std::string& text, double& into) { into = number_in(text).value_or(0); }
void take_value(const std::string& text, std::optional<double>& into) { into = number_in(text); }

const std::string* value_at(const Values& values, std::string_view key) {
  const auto found = std::ranges::find(values, key, &Values::value_type::first);
  return found == values.end() ? nullptr : &found->second;
}

std::vector<EvidenceAccount> evidence_in(const Values& values) {
  std::vector<EvidenceAccount> all;
  while (value_at(values, evidence_key(all.size(), "sign")) != nullptr) {
    const std::size_t index = all.size();
    visit_fields(all.emplace_back(), [&](const char* key, auto& into) {
      if (const auto* text = value_at(values, evidence_key(index, key))) take_value(*text, into);
    });
  }
  return all;
}

}  // namespace

bus::DeviceStatus status_of(const FindingAccount& finding) {
  bus::DeviceStatus status{.level = finding.severe ? bus::Level::error : bus::Level::warn,
                           .name = finding.device + "/" + finding.cause,
                           .message = message_of(finding),
                           .hardware_id = finding.device,
                           .values = values_of(finding)};
  if (finding.until_s) status.level = bus::Level::ok;
  return status;
}

std::optional<FindingAccount> finding_of(const bus::DeviceStatus& status) {
  const std::size_t slash = status.name.find('/');
  if (slash == std::string::npos || value_at(status.values, "since_s") == nullptr) return {};
  FindingAccount finding;
  visit_fields(finding, [&](std::string_view key, auto& into) {
    const auto* text = value_at(status.values, key);
    if constexpr (requires { take_value(*text, into); }) {
      if (text != nullptr) take_value(*text, into);
    } else {
      into = evidence_in(status.values);
    }
  });
  finding.device = status.name.substr(0, slash);
  finding.cause = status.name.substr(slash + 1);
  return finding;
}

FindingStatuses::FindingStatuses(const std::vector<bus::Device>& devices) {
  for (const auto& device : devices) devices_.push_back(device.name);
}

bus::DeviceStatus FindingStatuses::take(const diagnosis::Finding& finding) {
  auto status =
      status_of(diagnosis::account_of(finding, devices_.at(finding.device), measurement::Stamp{}));
  std::erase_if(open_, [&](const auto& one) { return one.name == status.name; });
  if (!finding.until) open_.push_back(status);
  return status;
}

}  // namespace drydock::host
