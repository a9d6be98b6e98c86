#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <vector>

#include "drivers/diagnosis/finding.hpp"

namespace drydock::diagnosis {

/// One number that speaks for a finding, in words.
struct EvidenceAccount {
  std::string sign, quantity;
  double value = 0, limit = 0;
  std::string unit;  ///< of value and limit; empty: a count
};

/// A finding as all outputs tell it: lines, JSON, the bus, recordings, pages.
struct FindingAccount {
  std::string device, cause;
  bool severe = false;  ///< its values are missing or false; else some are lost or worse
  double since_s = 0, found_s = 0;  ///< from a start that each output names
  std::optional<double> until_s;    ///< empty: it lasts
  double confidence = 0;            ///< 0 to 1: how sure the word is
  std::vector<EvidenceAccount> evidence;
  std::string meaning, advice;
};

/// `start`: the time from which since_s, found_s and until_s count.
FindingAccount account_of(const Finding& finding, std::string_view device, Stamp start);

/// Calls `field(name, value)` for every field. These names are the keys of all outputs.
template <class Account, class Field>
requires std::same_as<std::remove_const_t<Account>, EvidenceAccount>
void visit_fields(Account& account, Field&& field) {
  field("sign", account.sign);
  field("quantity", account.quantity);
  field("value", account.value);
  field("limit", account.limit);
  field("unit", account.unit);
}

template <class Account, class Field>
requires std::same_as<std::remove_const_t<Account>, FindingAccount>
void visit_fields(Account& account, Field&& field) {
  field("device", account.device);
  field("cause", account.cause);
  field("severe", account.severe);
  field("since_s", account.since_s);
  field("found_s", account.found_s);
  field("until_s", account.until_s);
  field("confidence", account.confidence);
  field("evidence", account.evidence);
  field("meaning", account.meaning);
  field("advice", account.advice);
}

}  // namespace drydock::diagnosis
