#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "estimators/external/answer_line.hpp"
#include "estimators/external/gives.hpp"
#include "estimators/pipeline/peer.hpp"

namespace drydock::external {

/// What a line of the other program says.
struct Answer {
  using Flaw = external::Flaw;
  std::uint64_t step = 0;                            ///< 0: the line does not say it
  std::vector<pipeline::OutsideEstimate> estimates;  ///< the good ones, before the flaw
  Flaw flaw = Flaw::none;
  std::string what;  ///< of the flaw, in words
};

Answer read_answer(std::string_view line, Gives gives);

}  // namespace drydock::external
