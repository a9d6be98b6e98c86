#include <array>

#include "hil/study/calibration/calibration_study.hpp"
#include "hil/study/leveling/leveling_study.hpp"
#include "hil/study/mixing/mixing_study.hpp"
#include "hil/study/roll/roll_study.hpp"
#include "hil/study/study.hpp"
#include "hil/study/velocity/velocity_study.hpp"

namespace drydock::study {

std::span<const Study> studies() {
  static constexpr std::array all{
      Study{"leveling", "Leveling: roll and pitch from an IMU and a speed log (Hong et al. 2000)",
            leveling_study},
      Study{"mixing",
            "Mixing: attitude held by accelerometers, gains by fuzzy inference (Kim et al. 1996)",
            mixing_study, mixing_workloads},
      Study{"roll", "Roll: from the strengths of GPS signals (Hong, Kim, Ryoo, Lee 2015)",
            run_roll_study},
      Study{"velocity",
            "Velocity: a vehicle model aids inertial navigation for 5.5 h under water (Lee et al. "
            "2016)",
            velocity_study, nullptr, velocity_case_names},
      Study{"calibration",
            "Calibration: do the bounds of mounting, scale, latency and deviation hold?",
            calibration_study},
  };
  return all;
}

}  // namespace drydock::study
