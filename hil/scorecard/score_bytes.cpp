#include "hil/scorecard/score_bytes.hpp"

#include <nlohmann/json.hpp>

namespace nlohmann {

template <class T>
struct adl_serializer<std::optional<T>> {
  static void to_json(json& to, const std::optional<T>& from) { to = from ? json(*from) : json(); }
  static void from_json(const json& from, std::optional<T>& to) {
    to = from.is_null() ? std::optional<T>() : from.get<T>();
  }
};

}  // namespace nlohmann

namespace drydock::scorecard {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(FindingScore, found_s, word, right_device, right_word, before,
                                   others)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(EstimatorScore, name, error_deg, usual_deg, nees, valid_share,
                                   wrong_while_valid_s, usual_nees, horizontal_m, usual_m,
                                   recover_s, lost)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Score, device, fault, amount, layer, detect_s, sign, finding,
                                   recover_s, lost, others_lost, wrong, mistimed, lies, example,
                                   estimators)

std::string to_bytes(const Score& score) {
  std::string bytes;
  nlohmann::json::to_cbor(nlohmann::json(score), bytes);
  return bytes;
}

Score score_from(const std::string& bytes) { return nlohmann::json::from_cbor(bytes).get<Score>(); }

}  // namespace drydock::scorecard
