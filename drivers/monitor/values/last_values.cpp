#include "drivers/monitor/values/last_values.hpp"

#include <fmt/format.h>

#include <cmath>

#include "drivers/monitor/values/shown_fields.hpp"

namespace drydock::monitor {

/// Puts the fields of one measurement into their slots. A field without a value keeps the last one.
class LastValues::Collector {
 public:
  Collector(OfType& into, Stamp at) : into_(into), at_(at) {}

  void operator()(std::string_view field, std::string_view word) {
    Slot& slot = slot_of(field);
    slot.word = word;
    slot.at = at_;
  }
  void operator()(std::string_view field, double number) { put(field, {&number, 1}); }
  void operator()(std::string_view field, int number) {
    (*this)(field, static_cast<double>(number));
  }
  template <class T>
  void operator()(std::string_view field, const std::optional<T>& maybe) {
    if (maybe)
      (*this)(field, *maybe);
    else
      slot_of(field);  // so that the fields keep their order
  }
  void operator()(std::string_view field, const Eigen::Vector3d& v) { put(field, {v.data(), 3}); }
  void operator()(std::string_view field, const std::array<std::optional<double>, 4>& beams) {
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < beams.size(); ++i) numbers[i] = beams[i].value_or(std::nan(""));
    for (const double number : numbers)
      if (!std::isnan(number)) return put(field, numbers);
  }
  template <std::size_t N>
  void operator()(std::string_view field,
                  const boost::container::static_vector<measurement::Satellite, N>& satellites) {
    into_.satellites.assign(satellites.begin(), satellites.end());
    (*this)(field, static_cast<double>(satellites.size()));
  }

 private:
  Slot& slot_of(std::string_view field) {
    for (auto& slot : into_.slots)
      if (slot.field == field) return slot;
    into_.slots.push_back({.field = field});
    return into_.slots.back();
  }
  void put(std::string_view field, std::span<const double> numbers) {
    Slot& slot = slot_of(field);
    std::ranges::copy(numbers, slot.numbers.begin());
    slot.size = static_cast<std::uint8_t>(numbers.size());
    slot.at = at_;
  }

  OfType& into_;
  Stamp at_;
};

namespace {

ShownValue shown_satellite(const measurement::Satellite& satellite, const DisplayUnits& units) {
  ShownValue value;
  visit_fields(satellite, [&](std::string_view field, const auto& content) {
    using Content = std::decay_t<decltype(content)>;
    if constexpr (std::is_same_v<Content, std::string_view>) {
      value.name = content;
    } else if constexpr (std::is_same_v<Content, bool>) {
      value.text += content ? "  used" : "";
    } else if constexpr (std::is_same_v<Content, std::optional<double>>) {
      if (!content) return;
      const auto part = units.shown(field, {&*content, 1});
      value.text += fmt::format("{}{} {}", value.text.empty() ? "" : "  ", part.name, part.full());
    } else {
      value.name += fmt::format(" {}", content);
    }
  });
  return value;
}

}  // namespace

void LastValues::on_measurement(const measurement::Measurement& measurement) {
  const auto& origin = measurement::origin_of(measurement);
  OfType& into = types_[{origin.device, measurement.index()}];
  into.newest = origin;
  std::visit([&](const auto& m) { visit_shown(m, Collector(into, origin.received_at)); },
             measurement);
}

NewestOrigin LastValues::newest(std::uint16_t device) const {
  NewestOrigin newest;
  for (auto type = types_.lower_bound({device, 0});
       type != types_.end() && type->first.first == device; ++type)
    if (!newest || type->second.newest.received_at > newest->received_at)
      newest = type->second.newest;
  return newest;
}

void LastValues::list(const OfType& all, Stamp newest, const DisplayUnits& units,
                      std::vector<ShownValue>& into) {
  for (const auto& slot : all.slots) {
    if (!slot.known()) continue;
    into.push_back(slot.word.empty()
                       ? units.shown(slot.field, std::span(slot.numbers).first(slot.size))
                       : ShownValue{std::string(slot.field), std::string(slot.word), ""});
    into.back().older_s = measurement::seconds(newest - slot.at);
  }
  for (const auto& satellite : all.satellites) into.push_back(shown_satellite(satellite, units));
}

std::vector<ShownValue> LastValues::values(std::uint16_t device, const DisplayUnits& units) const {
  std::vector<ShownValue> all;
  const auto last = newest(device);
  for (auto type = types_.lower_bound({device, 0});
       type != types_.end() && type->first.first == device; ++type)
    list(type->second, last->received_at, units, all);
  return all;
}

}  // namespace drydock::monitor
