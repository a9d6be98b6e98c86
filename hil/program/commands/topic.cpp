#include "hil/topic/topic.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>

#include "hil/program/commands.hpp"
#include "hil/program/load_rig.hpp"
#include "hil/program/options.hpp"

namespace drydock::program {

namespace {

/// DDS puts rt before a topic of ROS: rt/imu/data is /imu/data.
std::string as_ros_says(const std::string& topic) {
  return topic.starts_with("rt/") ? topic.substr(2) : topic;
}

/// Of the only word: a topic in the place of the rig.
void must_be_source(const std::string& source, const std::string& name) {
  std::error_code unknown;
  const bool is_topic = source.starts_with('/') || source.starts_with("rt/");
  if (!name.empty() || !is_topic || std::filesystem::exists(source, unknown)) return;
  const auto topic = as_ros_says(source);
  throw std::runtime_error(fmt::format(
      "{0} is a topic: of which rig, or of which recording? drydock topic my-rig.toml {0} reads "
      "the bus that the rig file names, drydock topic dive.mcap {0} a recording",
      topic));
}

}  // namespace

void add_topic(CLI::App& app, Command& command) {
  struct Arguments {
    std::string source;
    topic::EchoOptions options;
  };
  auto a = std::make_shared<Arguments>();
  auto* sub = app.add_subcommand(
      "topic",
      "Print messages as JSON lines: what drivers say on the bus, or what a recording has");
  sub->footer(
      "Example: drydock topic rig_config/rigs/demo.toml dvl --for 10s\n"
      "         drydock topic dive.mcap /diagnostics --count 3");
  sub->add_option("SOURCE", a->source,
                  "rig file (TOML) whose drivers run somewhere, or recording (MCAP)")
      ->required();
  sub->add_option("NAME", a->options.name,
                  "device, attitude estimator, diagnostics, or topic of a recording; default all");
  sub->add_option("--count", a->options.most, "so many messages, then it ends")
      ->check(positive_number);
  sub->add_option("--for", a->options.duration_s, "of a rig: 60s, 10min; default until Ctrl-C")
      ->transform(running_time);
  sub->callback([a, &command] {
    command = [a] {
      must_be_source(a->source, a->options.name);
      a->options.name = as_ros_says(a->options.name);
      if (a->source.ends_with(".mcap"))
        return topic::echo_recording(a->source, a->options, stdout, stderr);
      return topic::echo_bus(load_rig(a->source), a->options, stdout, stderr);
    };
  });
}

}  // namespace drydock::program
