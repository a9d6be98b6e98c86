#include "hil/summary/findings_json.hpp"

namespace drydock::summary {
namespace {

using FindingJson = nlohmann::ordered_json;

template <class Value>
FindingJson member_of(const Value& value) {
  return value;
}
FindingJson member_of(const std::optional<double>& number) {
  return number ? FindingJson(*number) : FindingJson(nullptr);
}

template <class Account>
FindingJson object_of(const Account& account);

FindingJson member_of(const std::vector<diagnosis::EvidenceAccount>& evidence) {
  FindingJson all = FindingJson::array();
  for (const auto& one : evidence) all.push_back(object_of(one));
  return all;
}

template <class Account>
FindingJson object_of(const Account& account) {
  FindingJson json;
  visit_fields(account, [&](const char* key, const auto& value) { json[key] = member_of(value); });
  return json;
}

}  // namespace

nlohmann::ordered_json findings_json(std::span<const diagnosis::FindingAccount> findings) {
  FindingJson all = FindingJson::array();
  for (const auto& finding : findings) all.push_back(object_of(finding));
  return all;
}

}  // namespace drydock::summary
