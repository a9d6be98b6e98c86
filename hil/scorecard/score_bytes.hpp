#pragma once

#include <string>

#include "hil/scorecard/score.hpp"

/// A score on its way from one process to another, as CBOR: every number to the last bit.
namespace drydock::scorecard {

std::string to_bytes(const Score& score);
/// The bytes are those of to_bytes().
Score score_from(const std::string& bytes);

}  // namespace drydock::scorecard
