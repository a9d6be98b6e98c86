#include <fmt/format.h>
#include <pybind11/stl.h>

#include "drivers/recordings/record/layouts.hpp"
#include "drivers/recordings/record/player.hpp"
#include "drivers/text/printable.hpp"
#include "hil/python/measurement_tables.hpp"
#include "hil/python/message_table.hpp"
#include "hil/python/outside_python.hpp"
#include "hil/python/topics.hpp"
#include "hil/python/warn.hpp"

namespace drydock::python {
namespace {

using Seconds = std::optional<double>;

std::chrono::nanoseconds moment_of(double seconds, const char* name) {
  constexpr double longest = 9e9;  // more than nanoseconds of 64 bits hold
  if (!(std::abs(seconds) < longest))
    throw std::invalid_argument(
        fmt::format("{} is {}, allowed: seconds since the first message", name, seconds));
  return measurement::from_seconds(seconds);
}

record::Selection selection_of(std::vector<std::string> only, Seconds from_s, Seconds to_s) {
  if (from_s && to_s && !(*from_s < *to_s))
    throw std::invalid_argument(
        fmt::format("from_s is {} and to_s is {}, allowed: from_s before to_s", *from_s, *to_s));
  record::Selection part{.only = std::move(only), .from = {}, .to = {}};
  if (from_s) part.from = moment_of(*from_s, "from_s");
  if (to_s) part.to = moment_of(*to_s, "to_s");
  return part;
}

record::Recording opened(const std::string& path, const record::Selection& part) {
  auto recording = record::Recording::open(path).value();
  if (const auto why = record::misfit(part, recording); !why.empty())
    throw std::invalid_argument(path + ": " + why);
  return recording;
}

class Listener final : public device::Listener {
 public:
  void on_measurement(const measurement::Measurement& m) override { tables.add(m); }
  void on_state(const device::Device&, const device::Transition&) override {}

  MeasurementTables tables;
};

py::dict decode_recording(const std::string& path, std::vector<std::string> only, Seconds from_s,
                          Seconds to_s) {
  const auto part = selection_of(std::move(only), from_s, to_s);
  Listener listener;
  std::vector<std::string> devices;
  std::string damage;
  {
    const OutsidePython others_run;
    auto recording = opened(path, part);
    const auto rig = record::rig_of(recording).value();
    for (const auto& device : rig.devices) devices.push_back(device.name);
    const auto player = record::Player::make(recording, rig, part, listener).value();
    record::play(recording, part, *player);
    damage = recording.damage();
  }
  warn(damage);
  return listener.tables.take(devices);
}

/// The tables by topic, and what could not be read.
class Topics {
 public:
  void add(const record::Understood& message) {
    const auto& topic = message.channel->topic;
    auto found = tables_.find(topic);
    if (found == tables_.end()) {
      const record::Layout& layout = layouts_.of(message);
      if (!layout) return unread_.add(topic, layout.error().line);
      found = tables_.emplace(topic, MessageTable(*layout)).first;
    }
    if (const auto why = found->second.add(message); !why.empty()) unread_.add(topic, why);
  }

  py::dict take() {
    for (const auto& note : unread_.notes()) warn(text::printable(note));
    py::dict all;
    for (auto& [topic, table] : tables_)
      if (py::dict columns = table.take(); !columns.empty())
        all[py::str(topic)] = std::move(columns);
    return all;
  }

 private:
  record::Layouts layouts_;
  std::map<std::string, MessageTable> tables_;
  record::Unread unread_;
};

py::dict read_recording(const std::string& path, std::vector<std::string> only, Seconds from_s,
                        Seconds to_s) {
  const auto part = selection_of(std::move(only), from_s, to_s);
  Topics topics;
  std::string damage;
  {
    const OutsidePython others_run;
    auto recording = opened(path, part);
    const auto begin = recording.begin().value_or(measurement::Stamp{});
    while (const auto event = recording.next()) {
      const auto* message = std::get_if<record::Understood>(&*event);
      if (message != nullptr && part.takes(*message->channel) && part.holds(message->at, begin))
        topics.add(*message);
    }
    damage = recording.damage();
  }
  warn(damage);
  return topics.take();
}

}  // namespace

void add_recordings(py::module_& module) {
  using py::arg;
  const auto part = [&](const char* name, auto function, const char* doc) {
    module.def(name, function, arg("path"), py::kw_only(), arg("only") = std::vector<std::string>(),
               arg("from_s") = py::none(), arg("to_s") = py::none(), doc);
  };
  part("decode_recording", &decode_recording,
       "The recorded bytes through their drivers: by device, by type, a table of measurements.");
  part("read_recording", &read_recording,
       "The recorded messages, as they were decoded at the time: by topic, a table.");
}

}  // namespace drydock::python
