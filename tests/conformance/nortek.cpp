#include <array>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/sentence.hpp"

/// Nortek's NMEA sentences, one on each line: "ok" or the error, then the sentence. The columns are
/// those of the parser in pynmea2; the sentences come from its test suite.
namespace drydock::conformance {

namespace {

constexpr double kelvin_at_0_c = 273.15;
constexpr const char* no_velocity = "-32.768";

constexpr std::array beam{
    Slot{"beam", -1, 1},
    Slot{"after_trigger_s", -1, 4, 1e-3},
    Slot{"after_sentence_s", -1, 5, 1e-3},
    Slot{"velocity_mps", -1, 6, 1, 0, no_velocity},
    Slot{"figure_of_merit_mps", -1, 7, 1, 0, "10"},
    Slot{"distance_m", -1, 8, 1, 0, "0"},
    Slot{"status", -1, 9},
};
constexpr std::array speeds{
    Slot{"after_trigger_s", -1, 1, 1e-3},
    Slot{"after_sentence_s", -1, 2, 1e-3},
    Slot{"speed_mps", -1, 3},
    Slot{"direction_deg", -1, 4},
    Slot{"figure_of_merit_mps", -1, 5, 1, 0, "10"},
    Slot{"distance_m", -1, 6, 1, 0, "0"},
};
constexpr std::array velocity{
    Slot{"ping_time_s", -1, 1},
    Slot{"after_trigger_s", -1, 2, 1e-3},
    Slot{"after_sentence_s", -1, 3, 1e-3},
    Slot{"velocity_mps", 0, 4, 1, 0, no_velocity},
    Slot{"velocity_mps", 1, 5, 1, 0, no_velocity},
    Slot{"velocity_mps", 2, 6, 1, 0, no_velocity},
    Slot{"figure_of_merit_mps", -1, 7, 1, 0, "10"},
    Slot{"distance_m", 0, 8, 1, 0, "0"},
    Slot{"distance_m", 1, 9, 1, 0, "0"},
    Slot{"distance_m", 2, 10, 1, 0, "0"},
    Slot{"distance_m", 3, 11, 1, 0, "0"},
    Slot{"battery_v", -1, 12},
    Slot{"sound_speed_mps", -1, 13},
    Slot{"temperature_k", -1, 15, 1, kelvin_at_0_c},
    Slot{"status", -1, 16},
};

constexpr std::array sentence_layouts{
    Layout{"PNORBT0", beam},     Layout{"PNORBT1", beam},     Layout{"PNORBT3", speeds},
    Layout{"PNORBT4", speeds},   Layout{"PNORBT6", velocity}, Layout{"PNORBT7", velocity},
    Layout{"PNORBT8", velocity}, Layout{"PNORBT9", velocity}, Layout{"PNORWT0", beam},
    Layout{"PNORWT1", beam},     Layout{"PNORWT3", speeds},   Layout{"PNORWT4", speeds},
    Layout{"PNORWT6", velocity}, Layout{"PNORWT7", velocity}, Layout{"PNORWT8", velocity},
    Layout{"PNORWT9", velocity},
};

}  // namespace

std::vector<Case> discover_nortek(const fs::path& folder) {
  return vectors(files_of(folder, ".txt"));
}

void compare_nortek(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  std::size_t number = 0;
  for (const std::string& line : lines_of(read_text(one.capture))) {
    ++number;
    const std::size_t start = line.find('$');
    if (line.starts_with('#') || start == line.npos) continue;
    const std::string sentence = line.substr(start, line.find_first_of(" \t", start) - start);
    if (line.starts_with("ok"))
      compare_sound("nortek", name, number, sentence,
                    find(sentence_layouts, fields_of(sentence).front()), score);
    else
      compare_damaged("nortek", name, number, sentence, score);
  }
}

}  // namespace drydock::conformance
