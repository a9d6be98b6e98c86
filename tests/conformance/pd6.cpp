#include <algorithm>
#include <array>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/sentence.hpp"

/// PD6 lines have no checksum. Each known line must give one message with the values of its columns
/// (Pathfinder DVL Guide, table 50). mm/s, m, degrees.
namespace drydock::conformance {

namespace {

constexpr double millimetre = 1e-3, kelvin_at_0_c = 273.15;

constexpr std::array attitude{Slot{"pitch_deg", -1, 1}, Slot{"roll_deg", -1, 2},
                              Slot{"heading_deg", -1, 3}};
constexpr std::array timing{Slot{"salinity_ppt", -1, 2},
                            Slot{"temperature_k", -1, 3, 1, kelvin_at_0_c}, Slot{"depth_m", -1, 4},
                            Slot{"sound_speed_mps", -1, 5}, Slot{"built_in_test", -1, 6}};
constexpr Slot component(int element, std::size_t column) {
  return {"velocity_mps", element, column, millimetre, 0, "-32768", true};
}
constexpr std::array four{component(0, 1), component(1, 2), component(2, 3), component(3, 4)};
constexpr std::array three{component(0, 1), component(1, 2), component(2, 3)};
constexpr std::array distances{Slot{"distance_m", 0, 1}, Slot{"distance_m", 1, 2},
                               Slot{"distance_m", 2, 3}, Slot{"range_m", -1, 4, 1, 0, "0"},
                               Slot{"since_good_s", -1, 5}};

constexpr std::array line_layouts{
    Layout{"SA", attitude},      Layout{"TS", timing},        Layout{"WI", four, 5, "A"},
    Layout{"WS", three, 4, "A"}, Layout{"WE", three, 4, "A"}, Layout{"WD", distances},
    Layout{"BI", four, 5, "A"},  Layout{"BS", three, 4, "A"}, Layout{"BE", three, 4, "A"},
    Layout{"BD", distances},
};

/// `:XX,a,b` without colon and padding.
std::vector<std::string> fields_of_line(std::string line) {
  std::erase(line, ' ');
  std::erase(line, ':');
  return split(line, ',');
}

}  // namespace

std::vector<Case> discover_pd6(const fs::path& folder) {
  auto files = files_of(folder, ".txt");
  std::erase_if(files, [](const fs::path& file) { return !read_text(file).starts_with(":"); });
  return vectors(files);
}

void compare_pd6(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  const auto ours = decode("pd6", one.capture).messages;
  std::size_t at = 0, number = 0;
  for (const std::string& line : lines_of(read_text(one.capture))) {
    ++number;
    const auto fields = fields_of_line(line);
    const Layout* layout = find(line_layouts, fields.front());
    if (!layout) continue;
    if (at == ours.size() || ours[at]["type"] != fields.front()) {
      score.missed(name, number, line);
      continue;
    }
    Comparison c(name, number);
    compare(ours[at++], fields, *layout, c);
    score.add(c);
  }
  for (; at < ours.size(); ++at) score.unexpected(name, 0, ours[at].dump());
}

}  // namespace drydock::conformance
