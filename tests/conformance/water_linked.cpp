#include <array>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/sentence.hpp"

/// Water Linked serial sentences, one on each line: crc_ok or crc_bad, source, sentence, note. The
/// columns follow Water Linked, DVL serial protocol 2.7.
namespace drydock::conformance {

namespace {

constexpr std::array bottom_velocity{
    Slot{"velocity_mps", 0, 1, 1, 0, "", true},  Slot{"velocity_mps", 1, 2, 1, 0, "", true},
    Slot{"velocity_mps", 2, 3, 1, 0, "", true},  Slot{"altitude_m", -1, 5, 1, 0, "-1", true},
    Slot{"figure_of_merit_mps", -1, 6},          Slot{"time_of_validity_s", -1, 8, 1e-6},
    Slot{"time_of_transmission_s", -1, 9, 1e-6}, Slot{"interval_s", -1, 10, 1e-3},
};
constexpr std::array water_velocity{
    Slot{"velocity_mps", 0, 1, 1, 0, "", true},
    Slot{"velocity_mps", 1, 2, 1, 0, "", true},
    Slot{"velocity_mps", 2, 3, 1, 0, "", true},
    Slot{"figure_of_merit_mps", -1, 5},
    Slot{"time_of_validity_s", -1, 7, 1e-6},
    Slot{"time_of_transmission_s", -1, 8, 1e-6},
    Slot{"interval_s", -1, 9, 1e-3},
};
constexpr std::array transducer{
    Slot{"id", -1, 1},       Slot{"velocity_mps", -1, 2}, Slot{"distance_m", -1, 3, 1, 0, "-1"},
    Slot{"rssi_dbm", -1, 4}, Slot{"noise_dbm", -1, 5},
};
constexpr std::array dead_reckoning{
    Slot{"time_s", -1, 1},
    Slot{"position_m", 0, 2},
    Slot{"position_m", 1, 3},
    Slot{"position_m", 2, 4},
    Slot{"position_deviation_m", -1, 5},
    Slot{"roll_deg", -1, 6},
    Slot{"pitch_deg", -1, 7},
    Slot{"yaw_deg", -1, 8},
};
constexpr std::array old_velocity{
    Slot{"interval_s", -1, 1, 1e-3},
    Slot{"velocity_mps", 0, 2, 1, 0, "", true},
    Slot{"velocity_mps", 1, 3, 1, 0, "", true},
    Slot{"velocity_mps", 2, 4, 1, 0, "", true},
    Slot{"figure_of_merit_mps", -1, 5},
    Slot{"altitude_m", -1, 6, 1, 0, "-1", true},
};
constexpr std::array old_ranges{
    Slot{"distance_m", 0, 1, 1, 0, "-1"},
    Slot{"distance_m", 1, 2, 1, 0, "-1"},
    Slot{"distance_m", 2, 3, 1, 0, "-1"},
    Slot{"distance_m", 3, 4, 1, 0, "-1"},
};

constexpr std::array wrz_layouts{
    Layout{"wrz", bottom_velocity, 4, "y"},
    Layout{"wrs", water_velocity, 4, "y"},
    Layout{"wru", transducer},
    Layout{"wrp", dead_reckoning},
    Layout{"wrx", old_velocity, 7, "y"},
    Layout{"wrt", old_ranges},
};

bool is_vector(const std::vector<std::string>& columns) {
  return columns.size() >= 3 && (columns[0] == "crc_ok" || columns[0] == "crc_bad");
}

}  // namespace

std::vector<Case> discover_water_linked(const fs::path& folder) {
  auto files = files_of(folder, ".txt");
  std::erase_if(files, [](const fs::path& file) {
    const auto lines = lines_of(read_text(file));
    return std::ranges::none_of(lines,
                                [](const auto& line) { return is_vector(split(line, '\t')); });
  });
  return vectors(files);
}

void compare_water_linked(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  std::size_t number = 0;
  for (const std::string& line : lines_of(read_text(one.capture))) {
    ++number;
    const auto columns = split(line, '\t');
    if (!is_vector(columns)) continue;
    const std::string& sentence = columns[2];
    if (columns[0] == "crc_ok")
      compare_sound("water-linked", name, number, sentence,
                    find(wrz_layouts, fields_of(sentence).front()), score);
    else
      compare_damaged("water-linked", name, number, sentence, score);
  }
}

}  // namespace drydock::conformance
