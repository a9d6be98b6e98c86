#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "drivers/diagnosis/symptom.hpp"

namespace drydock::diagnosis {

/// Keeps all signs that monitors tell.
struct Signs : SymptomSink {
  void see(const Symptom& symptom) override { all.push_back(symptom); }
  bool has(Sign sign) const { return std::ranges::count(all, sign, &Symptom::sign) > 0; }
  bool has(Sign sign, std::uint16_t device) const {
    return std::ranges::any_of(
        all, [&](const Symptom& s) { return s.sign == sign && s.device == device; });
  }
  const Symptom& first(Sign sign) const { return *std::ranges::find(all, sign, &Symptom::sign); }

  std::vector<Symptom> all;
};

inline Stamp at_s(double s) { return Stamp{measurement::from_seconds(1000 + s)}; }

}  // namespace drydock::diagnosis
