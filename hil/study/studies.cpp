#include "hil/study/study.hpp"

#include <array>

#include "hil/study/roll_study.hpp"

namespace drydock::study {

std::span<const Study> studies() {
  static constexpr std::array all{
      Study{"roll", "GPS roll (Hong, Kim, Ryoo, Lee 2015)", run_roll_study}};
  return all;
}

}  // namespace drydock::study
