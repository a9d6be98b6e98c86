#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "drivers/wire/described/description.hpp"
#include "rig_config/load.hpp"

/// Reads the files that describe a sensor (docs/sensors/described.md) into plans of the codec.
namespace drydock::rig_config {

using wire::described::DescriptionPtr;

/// A protocol with this ending is the name of a description.
constexpr bool is_description(std::string_view protocol) { return protocol.ends_with(".toml"); }

Loaded<DescriptionPtr> load_description(const std::string& path);
Loaded<DescriptionPtr> load_description_text(std::string_view text, const std::string& path);

/// The description of that name in the folder of `beside`, or else the one that is built in.
Loaded<DescriptionPtr> find_description(const std::string& name, const std::string& beside);

/// A file of rig_config/devices. They are part of the program.
struct BuiltInDescription {
  std::string_view name, text;
};
std::span<const BuiltInDescription> built_in_descriptions();
/// All of them, read once.
const std::vector<DescriptionPtr>& shipped_descriptions();

}  // namespace drydock::rig_config
