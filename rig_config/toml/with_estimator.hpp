#pragma once

#include <span>
#include <string>
#include <string_view>

namespace drydock::rig_config {

/// A rig file with one estimator in the place of all of its own, and without [[expect]].
/// `choice`: the name of an estimator of the rig, or a kind, then `:key=value` for each other key
/// (`reckoning.scale_sigma=0.01` inside a table; no value: the key goes). A kind that the rig does
/// not have gets the rig's first device for each key that names one, of those that are not in
/// `left_out`. Throws std::invalid_argument with one line.
std::string with_estimator(std::string_view rig, std::string_view choice,
                           std::span<const std::string> left_out = {});

}  // namespace drydock::rig_config
