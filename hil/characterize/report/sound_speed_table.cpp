#include "hil/characterize/report/sound_speed_table.hpp"

#include <fmt/format.h>

namespace drydock::characterize {

report::Table sound_speed_table(const std::string& device,
                                const measurement::SoundSpeedUsed::Means& means) {
  const std::string equation{
      measurement::sound_speed_equations[static_cast<std::size_t>(means.equation)]};
  return {
      device + ": speed of sound",
      {"", "mean"},
      {{"used [m/s]", fmt::format("{:.1f}", means.used_mps)},
       {"of its water [m/s]", fmt::format("{:.1f}", means.of_water_mps)},
       {"velocities and ranges are too large by [%]", fmt::format("{:.2f}", 100 * means.error())}},
      fmt::format("Its water by the equation `{}`: {:.2f} degC, {:.1f} ppt and {:.1f} m, as the "
                  "DVL measured them or was told. `sound_speed = {{ source = \"computed\" }}` in "
                  "the rig file puts velocities and ranges right.",
                  equation, means.temperature_k - measurement::melting_point_k, means.salinity_ppt,
                  means.depth_m)};
}

}  // namespace drydock::characterize
