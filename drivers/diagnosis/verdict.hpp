#pragma once

#include <optional>
#include <span>

#include "drivers/diagnosis/cause.hpp"
#include "drivers/diagnosis/symptom.hpp"

namespace drydock::diagnosis {

struct Verdict {
  Cause cause = Cause::silent;
  double confidence = 0;
  Sign by = Sign::silent;  ///< the sign that decided
};

/// What the present signs of one device mean together. Empty: they are not enough.
std::optional<Verdict> verdict_on(std::span<const Symptom> signs);

}  // namespace drydock::diagnosis
