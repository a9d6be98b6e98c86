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
  FindingAccount account{.device = std::string(device),
                         .cause = std::string(facts.name),
                         .severe = is_severe(finding.cause),
                         .since_s = measurement::seconds(finding.since - start),
                         .found_s = measurement::seconds(finding.found - start),
                         .until_s = {},
                         .confidence = finding.confidence,
                         .evidence = {},
                         .meaning = std::string(facts.meaning),
                         .advice = std::string(facts.advice)};
  if (finding.until) account.until_s = measurement::seconds(*finding.until - start);
  for (const Evidence& one : finding.evidence) account.evidence.push_back(evidence_account(one));
  return account;
}

bool is_severe(Cause cause) {
  switch (cause) {
    case Cause::silent:
    case Cause::port_lost:
    case Cause::wrong_baud:
    case Cause::bus_off:
    case Cause::address_stolen:
    case Cause::stuck:
    case Cause::bias:
    case Cause::drift:
    case Cause::delay:
    case Cause::bottom_lost:
    case Cause::satellites_blocked:
    case Cause::hot:
    case Cause::mounting:
    case Cause::scale: return true;
    default: return false;
  }
}

}  // namespace drydock::diagnosis
