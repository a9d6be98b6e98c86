#include "drivers/monitor/screen/screen_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace drydock::monitor {
namespace {

char small(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::string searched_text(const ShownFrame& frame) {
  std::string text = frame.name + ' ';
  for (const auto byte : frame.bytes) text += fmt::format("{:02X} ", byte);
  for (const auto& field : frame.fields) text += field.name + ' ';
  return text;
}

}  // namespace

bool passes(const std::string& filter, const std::string& text) {
  const auto same = [](char wanted, char there) {
    return wanted == there || wanted == small(there);
  };
  return std::search(text.begin(), text.end(), filter.begin(), filter.end(),
                     [&](char there, char wanted) { return same(wanted, there); }) != text.end() ||
         filter.empty();
}

std::vector<const ShownValue*> chosen_values(const ScreenState& state) {
  std::vector<const ShownValue*> chosen;
  if (state.choice.device >= state.devices.size()) return chosen;
  for (const auto& value : state.devices[state.choice.device].values)
    if (passes(state.choice.filter, value.name + ' ' + value.text)) chosen.push_back(&value);
  return chosen;
}

std::vector<const ShownFrame*> chosen_frames(const ScreenState& state) {
  std::vector<const ShownFrame*> chosen;
  for (const auto& frame : state.wire.frames)
    if (passes(state.choice.filter, searched_text(frame))) chosen.push_back(&frame);
  return chosen;
}

}  // namespace drydock::monitor
