#pragma once

#include "estimators/consistency/surge.hpp"

namespace drydock::consistency {

/// The law of a shaft. What a fault taught it is denied for ever, and then it learns no more. So
/// while the shaft is accused again and again a second law learns beside it. When that one has
/// learned for as long as the first had, and fits far better, it takes its place.
/// docs/estimators/consistency.md
class ShaftLaw {
 public:
  /// One step of time. `quiet`: nothing accuses the shaft, so the state teaches the law. `accused`:
  /// its test has fired.
  void take(const Surge::Input& input, double dt, bool quiet, bool accused);
  /// The second law took the place of the first in the last step: what was compared with the first
  /// begins anew.
  bool begins_anew() const { return begins_anew_; }
  std::optional<Surge::Answer> answer() const { return law_.answer(); }

 private:
  struct Rival {
    Surge law{};
    double until_s = 0, age_s = 0, quiet_s = 0;
    double of_first = 0, of_own = 0;  ///< means of the squares of what both said wrong lately

    void take(const Surge::Input& input, double dt, const std::optional<Surge::Answer>& first,
              bool accused);
    bool is_over(bool accused) const;
    bool fits_far_better() const;
  };

  Surge law_;
  double learned_s_ = 0;
  std::optional<Rival> rival_;
  bool begins_anew_ = false;
};

}  // namespace drydock::consistency
