#include "hil/replay/rigs/part_choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "drivers/link/uri.hpp"
#include "hil/replay/rigs/rig_readers.hpp"

namespace drydock::replay {
namespace {

using rig_config::DeviceConfig;
using Indices = std::vector<std::size_t>;

class PartChoice {
 public:
  PartChoice(const rig_config::Rig& rig, const RigCaptures& captures,
             const std::vector<CapturePart>& parts)
      : rig_(rig),
        captures_(captures),
        parts_(parts),
        readers_(readers_of(rig, captures.how)),
        part_of_(rig.devices.size()) {
    refuse_wrong_names();
  }

  std::vector<std::optional<std::size_t>> made() {
    for (std::size_t i = 0; i < rig_.devices.size(); ++i)
      part_of_[i] = file_named_for(i) != nullptr ? part_of_its_file(i) : part_that_fits(i);
    refuse_doubles();
    return std::move(part_of_);
  }

 private:
  const std::string& name_of(std::size_t device) const { return rig_.devices[device].name; }

  const RigCaptures::File* file_named_for(std::size_t device) const {
    const auto found =
        std::ranges::find(captures_.files, name_of(device), &RigCaptures::File::device);
    return found == captures_.files.end() ? nullptr : &*found;
  }

  void refuse_wrong_names() const {
    for (const auto& file : captures_.files) {
      if (file.device.empty()) continue;
      if (std::ranges::find(rig_.devices, file.device, &DeviceConfig::name) == rig_.devices.end()) {
        std::vector<std::string> names;
        for (const auto& device : rig_.devices) names.push_back(device.name);
        throw std::runtime_error(fmt::format("{}={}: no device of {}; allowed: {}", file.device,
                                             file.path, rig_.file, fmt::join(names, ", ")));
      }
    }
  }

  bool may_read(std::size_t device, const CapturePart& part) const {
    return part.frames == readers_[device].on_bus &&
           (captures_.how.interface.empty() || part.name == captures_.how.interface);
  }

  /// A file that was named for a device is for no other, unless it was named without one too.
  Indices parts_for(std::size_t device) const {
    Indices fitting;
    const auto* named = file_named_for(device);
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      const bool is_free = std::ranges::any_of(captures_.files, [&](const RigCaptures::File& file) {
        return file.device.empty() && file.path == parts_[i].file;
      });
      if ((named != nullptr ? named->path == parts_[i].file : is_free) &&
          may_read(device, parts_[i]))
        fitting.push_back(i);
    }
    return fitting;
  }

  std::size_t part_of_its_file(std::size_t device) const {
    const auto fitting = parts_for(device);
    if (fitting.size() == 1) return fitting.front();
    const auto chosen = chosen_of(device, fitting);
    if (chosen) return *chosen;
    const auto& file = file_named_for(device)->path;
    throw std::runtime_error(
        fitting.empty()
            ? fmt::format("{}: {} is read from a {}, and there is none{} in {}", name_of(device),
                          rig_.devices[device].protocol,
                          readers_[device].on_bus ? "CAN bus" : "line",
                          captures_.how.interface.empty() ? "" : " of that --interface", file)
            : fmt::format("{}: which part of {}? --interface names one: {}", name_of(device), file,
                          names_of(fitting)));
  }

  std::optional<std::size_t> part_that_fits(std::size_t device) const {
    const auto fitting = parts_for(device);
    if (readers_[device].on_bus && fitting.size() == 1) return fitting.front();
    return chosen_of(device, fitting);
  }

  std::optional<std::size_t> chosen_of(std::size_t device, const Indices& fitting) const {
    if (const auto same_name = by_name(device, fitting)) return same_name;
    return by_trial(device, fitting);
  }

  /// The part that has the name of the device, or of its link's target.
  std::optional<std::size_t> by_name(std::size_t device, const Indices& fitting) const {
    const auto link = link::parse_uri(rig_.devices[device].link).value();
    Indices named;
    std::ranges::copy_if(fitting, std::back_inserter(named), [&](std::size_t i) {
      const auto& name = parts_[i].name;
      return !name.empty() && (name == name_of(device) || name == link.target);
    });
    return named.size() == 1 ? std::optional(named.front()) : std::nullopt;
  }

  /// The part of which the driver makes measurements.
  std::optional<std::size_t> by_trial(std::size_t device, const Indices& fitting) const {
    Indices heard;
    std::ranges::copy_if(fitting, std::back_inserter(heard),
                         [&](std::size_t i) { return understands(readers_[device], parts_[i]); });
    if (heard.empty()) return {};
    if (heard.size() == 1) return heard.front();
    throw std::runtime_error(fmt::format(
        "{} makes measurements of several: {}; {}=FILE names the file, --interface the part",
        name_of(device), names_of(heard), name_of(device)));
  }

  std::string names_of(const Indices& which) const {
    std::vector<std::string> names;
    for (const std::size_t i : which) names.push_back(in_words(parts_[i]));
    return fmt::format("{}", fmt::join(names, ", "));
  }

  /// Two sensors of a kind cannot be told apart by what they say.
  void refuse_doubles() const {
    for (std::size_t i = 0; i < rig_.devices.size(); ++i)
      for (std::size_t k = i + 1; k < rig_.devices.size(); ++k) {
        const auto &one = rig_.devices[i], &other = rig_.devices[k];
        if (!part_of_[i] || part_of_[i] != part_of_[k] || one.link == other.link ||
            one.kind != other.kind || one.protocol != other.protocol ||
            (readers_[i].on_bus && one.address != other.address) ||
            (file_named_for(i) != nullptr && file_named_for(k) != nullptr))
          continue;
        const auto& file = parts_[*part_of_[i]].file;
        throw std::runtime_error(
            fmt::format("{} and {} ({}) may both have made {}; {}={} or {}={} says which", one.name,
                        other.name, one.protocol, file, one.name, file, other.name, file));
      }
  }

  const rig_config::Rig& rig_;
  const RigCaptures& captures_;
  const std::vector<CapturePart>& parts_;
  std::vector<RigReader> readers_;
  std::vector<std::optional<std::size_t>> part_of_;
};

}  // namespace

std::vector<std::optional<std::size_t>> parts_of_devices(const rig_config::Rig& rig,
                                                         const RigCaptures& captures,
                                                         const std::vector<CapturePart>& parts) {
  return PartChoice(rig, captures, parts).made();
}

}  // namespace drydock::replay
