#include "drivers/diagnosis/finding_account.hpp"

namespace drydock::diagnosis {
namespace {

EvidenceAccount evidence_account(const Evidence& evidence) {
  return {.sign = std::string(to_string(evidence.sign)),
          .quantity = std::string(evidence.quantity),
          .value = evidence.value,
          .limit = evidence.limit,
          .unit = std::string(evidence.unit)};
}

}  // namespace

FindingAccount account_of(const Finding& finding, std::string_view device, Stamp start) {
  const CauseFacts& facts = facts_of(finding.cause);
  FindingAccount account{
      .device = std::string(device),
      .cause = std::string(facts.name),
      .severe = facts.severe,
      .since_s = measurement::seconds(finding.since - start),
      .found_s = measurement::seconds(finding.found - start),
      .until_s = {},
      .confidence = finding.confidence,
      .evidence = {},
      .meaning = std::string(facts.meaning),
      .advice = std::string(finding.advice.empty() ? facts.advice : finding.advice)};
  if (finding.until) account.until_s = measurement::seconds(*finding.until - start);
  for (const Evidence& one : finding.evidence) account.evidence.push_back(evidence_account(one));
  return account;
}

}  // namespace drydock::diagnosis
