#include <array>
#include <regex>

#include "tests/conformance/comparers.hpp"
#include "tests/conformance/frame_vectors.hpp"

/// Xsens frames as vectors: identifier, payload, and the meaning from the manual in words. Our
/// values must equal those of the payload by the manual's layout, and the numbers in the words.
namespace drydock::conformance {

namespace {

/// `count` big-endian numbers of `size` bytes; ours = number * scale.
struct DataLayout {
  unsigned id;
  std::string_view type;
  std::vector<std::string> keys;
  std::size_t size, count;
  double scale;          ///< from the wire to our unit
  double quoted_factor;  ///< from the words' unit to ours
};

const std::array data_layouts{
    DataLayout{0x001, "error", {"code"}, 1, 1, 1, 1},
    DataLayout{0x005, "sample_time", {"device_time_s"}, 4, 1, 1e-4, 1e-4},
    DataLayout{0x006, "group_counter", {"counter"}, 2, 1, 1, 1},
    DataLayout{0x021, "quaternion", {"wxyz"}, 2, 4, 1.0 / 32767, 1},
    DataLayout{0x022, "euler_angles", {"roll_deg", "pitch_deg", "yaw_deg"}, 2, 3, 1.0 / 128, 1},
    DataLayout{0x032,
               "rate_of_turn",
               {"rate_x_degps", "rate_y_degps", "rate_z_degps"},
               2,
               3,
               degree / 512,
               degree},
    DataLayout{0x034,
               "acceleration",
               {"acceleration_x_mps2", "acceleration_y_mps2", "acceleration_z_mps2"},
               2,
               3,
               1.0 / 256,
               1},
};

/// Several numbers are in two's complement; a single number is unsigned.
double number_at(const std::vector<std::uint8_t>& data, const DataLayout& layout, std::size_t i) {
  std::int64_t value = 0;
  for (std::size_t b = 0; b < layout.size; ++b) value = value << 8 | data.at(i * layout.size + b);
  const std::int64_t range = std::int64_t{1} << (8 * layout.size);
  return static_cast<double>(layout.count > 1 && value >= range / 2 ? value - range : value);
}

json value_of(const json& ours, const DataLayout& layout, std::size_t i) {
  return layout.keys.size() == 1 && layout.count > 1 ? ours.at(layout.keys[0]).at(i)
                                                     : ours.at(layout.keys.at(i));
}

/// "z=9.8", "roll 90", "1.5,-2.25,9.8" : component and value.
std::vector<std::pair<std::size_t, double>> quoted(const std::string& words) {
  static const std::regex three(R"((-?[\d.]+),(-?[\d.]+),(-?[\d.]+))");
  static const std::regex one(R"(\b(x|y|z|roll|pitch|yaw)\s*=?\s*(-?\d+(?:\.\d+)?))");
  static const std::array<std::string_view, 6> axes{"x", "y", "z", "roll", "pitch", "yaw"};
  std::smatch found;
  std::vector<std::pair<std::size_t, double>> values;
  if (std::regex_search(words, found, three))
    for (std::size_t i = 0; i < 3; ++i) values.emplace_back(i, std::stod(found[i + 1]));
  else if (std::regex_search(words, found, one))
    for (std::size_t i = 0; i < axes.size(); ++i)
      if (found[1].str() == axes[i]) values.emplace_back(i % 3, std::stod(found[2]));
  return values;
}

void compare_vector(const json& ours, const FrameVector& vector, const DataLayout& layout,
                    Comparison& c) {
  const std::string name(layout.type);
  c.same("type", ours["type"], name);
  if (!c.agrees()) return;
  for (std::size_t i = 0; i < layout.count; ++i)
    c.number(name, value_of(ours, layout, i), number_at(vector.data, layout, i) * layout.scale,
             {layout.scale});
  for (const auto& [i, value] : quoted(vector.words))
    c.number(name + " as quoted", value_of(ours, layout, i), value * layout.quoted_factor,
             {layout.scale});
}

}  // namespace

std::vector<Case> discover_xsens(const fs::path& folder) { return frame_vector_files(folder); }

void compare_xsens(const Case& one, Score& score) {
  const std::string name = one.capture.filename().string();
  for (const FrameVector& vector : read_frame_vectors(one.capture)) {
    const auto layout = std::ranges::find(data_layouts, vector.id, &DataLayout::id);
    if (layout == data_layouts.end()) {
      score.note(name + ":" + std::to_string(vector.line) + ": no layout for this identifier");
      continue;
    }
    const auto decoded = decode_bytes("xsens", candump_line(vector)).messages;
    if (decoded.empty()) {
      score.missed(name, vector.line, vector.words);
      continue;
    }
    Comparison c(name, vector.line);
    compare_vector(decoded.front(), vector, *layout, c);
    score.add(c);
  }
}

}  // namespace drydock::conformance
