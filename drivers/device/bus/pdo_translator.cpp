#include "drivers/device/bus/pdo_translator.hpp"

namespace drydock::device {

namespace {

/// WIKA's process value has an index of its own.
constexpr std::uint32_t wika_value = 0x20900020, integer_value = 0x91300120;

std::uint32_t as_usual(std::uint32_t object) {
  return object == wika_value ? integer_value : object;
}

unsigned all_of(std::size_t objects) { return (1U << objects) - 1; }

}  // namespace

PdoTranslator::PdoTranslator(Pdos usual) : usual_count_(std::min(usual.size(), most)) {
  std::copy_n(usual.begin(), usual_count_, usual_.begin());
}

void PdoTranslator::learn(Pdos actual) {
  actual_count_ = std::min(actual.size(), most);
  std::copy_n(actual.begin(), actual_count_, actual_.begin());
  came_.fill(0);
}

std::optional<std::uint32_t> PdoTranslator::missing_in(Pdos actual) const {
  const auto has = [&](std::uint32_t object) {
    return std::ranges::any_of(actual, [&](const Pdo& pdo) {
      const auto mapped = std::span(pdo.objects).first(pdo.count);
      return !pdo.is_off() && std::ranges::any_of(mapped, [&](std::uint32_t sent) {
        return as_usual(sent) == object;
      });
    });
  };
  for (const Pdo& pdo : usual())
    for (std::size_t i = 0; i < pdo.count; ++i)
      if (!has(pdo.objects[i])) return pdo.objects[i];
  return {};
}

/// Puts the objects of a frame where the usual PDOs have them.
void PdoTranslator::take(const Pdo& pdo, const wire::CanFrame& frame) {
  std::size_t from = 0;
  for (std::size_t sent = 0; sent < pdo.count; ++sent) {
    const std::size_t bytes = (pdo.objects[sent] & 0xFF) / 8;
    for (std::size_t u = 0; u < usual_count_; ++u) {
      std::size_t to = 0;
      for (std::size_t i = 0; i < usual_[u].count; ++i) {
        if (usual_[u].objects[i] == as_usual(pdo.objects[sent])) {
          std::copy_n(frame.data.begin() + from, bytes, filled_[u].data.begin() + to);
          came_[u] |= 1U << i;
        }
        to += (usual_[u].objects[i] & 0xFF) / 8;
      }
    }
    from += bytes;
  }
}

PdoTranslator::Frames PdoTranslator::frames_of(const wire::CanFrame& frame) {
  const Frames as_it_is{{&frame, 1}, true};
  if (!translates() || frame.extended || frame.remote || frame.error) return as_it_is;
  const auto actual = std::span(actual_).first(actual_count_);
  const auto pdo = std::ranges::find_if(
      actual, [&](const Pdo& sent) { return !sent.is_off() && sent.id() == frame.id; });
  if (pdo == actual.end()) {
    const bool is_usual =
        std::ranges::any_of(usual(), [&](const Pdo& wanted) { return wanted.id() == frame.id; });
    return is_usual ? Frames{{}, false} : as_it_is;
  }
  if (frame.size < pdo->bytes()) return {{}, false};
  take(*pdo, frame);
  std::size_t count = 0;
  for (std::size_t u = 0; u < usual_count_; ++u) {
    if (came_[u] != all_of(usual_[u].count)) continue;
    came_[u] = 0;
    out_[count] = frame;
    out_[count].id = usual_[u].id();
    out_[count].size = static_cast<std::uint8_t>(usual_[u].bytes());
    out_[count].data = filled_[u].data;
    ++count;
  }
  return {std::span(out_).first(count), true};
}

}  // namespace drydock::device
