#pragma once

#include <vector>

#include "drivers/diagnosis/symptom.hpp"
#include "estimators/consistency/moment.hpp"

namespace drydock::consistency {

/// A receiver that has a fix stands in the air: radio waves do not reach into the water. A depth
/// sensor whose depth puts that antenna under water is off, from the start or from any time on.
class Immersion {
 public:
  static constexpr double deepest_m = 1.5;  ///< waves, and levels that nothing tells
  static constexpr double patience_s = 10;  ///< receivers go on for a while without sky

  explicit Immersion(const Tracks& tracks);

  template <class Distrusted>
  void step(const Moment& moment, const Distrusted& distrusted) {
    for (Depth& depth : depths_) {
      std::optional<double> deepest;
      for (const GnssTracks& receiver : tracks_.receivers)
        if (!distrusted(Devices{receiver.device}))
          if (const auto under = antenna_depth_m(depth, receiver, moment))
            deepest = std::max(deepest.value_or(*under), *under);
      note(depth, deepest, moment);
    }
  }

  /// Repeats the signs that last.
  void tell(Stamp now, diagnosis::SymptomSink& to) const;

 private:
  struct Depth {
    std::size_t track;
    double wet_s = 0;  ///< how long an antenna with a fix has been under water by this sensor
    Stamp since{};
    double antenna_m = 0;
  };
  std::optional<double> antenna_depth_m(const Depth& depth, const GnssTracks& receiver,
                                        const Moment& moment) const;
  static void note(Depth& depth, std::optional<double> antenna_m, const Moment& moment);

  const Tracks& tracks_;
  std::vector<Depth> depths_;
};

}  // namespace drydock::consistency
