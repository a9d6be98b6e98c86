#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace drydock::guess {

/// What a description takes: rig_config/schema/device.schema.json.
inline constexpr std::size_t most_sentences = 64;

/// How a sentence is cut into fields: at commas behind its id, or at one character behind each
/// number, as in $C320.5P0.2R-18.3T20.1 and "PRS 12.50,8.1".
struct SentenceForm {
  std::string id;
  std::string sub_id;  ///< its first field where that tells messages of one id apart
  std::string ends;    ///< empty: commas
  std::size_t fields = 0;

  auto operator<=>(const SentenceForm&) const =
      default;  // NOLINT(modernize-use-nullptr): clang 14 takes it for a 0
};

using SentenceRow = std::vector<std::string_view>;  ///< its fields
using SentenceForms = std::map<SentenceForm, std::vector<SentenceRow>>;

/// $PIXSE,HEAVE_ and $PIXSE,SPEED_ are two messages, and so are $PSXN,20 and $PSXN,23: few words
/// behind the id are part of it, and few integers where the columns behind them have other forms.
SentenceForms with_sub_ids(const SentenceForms& forms);

}  // namespace drydock::guess
