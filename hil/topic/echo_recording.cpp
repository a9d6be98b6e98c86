#include <fmt/format.h>

#include <map>
#include <set>

#include "drivers/recordings/record/message_layout.hpp"
#include "drivers/recordings/record/selection.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "hil/replay/reference/references.hpp"
#include "hil/topic/topic.hpp"

namespace drydock::topic {
namespace {

/// Prints the messages of the topics that were asked for.
class RecordedEcho {
 public:
  RecordedEcho(const EchoOptions& options, std::FILE* out) : options_(options), out_(out) {
    if (!options.name.starts_with('/')) selection_.only = {options.name};
    if (options.name.empty()) selection_.only.clear();
  }

  void hear(const record::Understood& message) {
    topics_.insert(message.channel->topic);
    if (!wants(message)) return;
    ++printed_;
    nlohmann::ordered_json line{{"topic", message.channel->topic},
                                {"at_s", measurement::seconds(message.at.time_since_epoch())}};
    for (const auto& [name, value] : replay::values_of(layout_of(*message.schema), message.cdr))
      line[name] = value;
    fmt::print(out_, "{}\n", text::json_of_any_text(line, -1));
  }
  bool full() const { return options_.most > 0 && printed_ >= options_.most; }
  std::uint64_t printed() const { return printed_; }
  const std::set<std::string>& topics() const { return topics_; }

 private:
  bool wants(const record::Understood& message) const {
    return options_.name.starts_with('/') ? message.channel->topic == options_.name
                                          : selection_.takes(*message.channel);
  }
  const record::MessageNode& layout_of(const mcap::Schema& schema) {
    if (!layouts_.contains(schema.name))
      layouts_[schema.name] = record::parse_definition(schema.text).value_or(record::MessageNode{});
    return layouts_[schema.name];
  }

  const EchoOptions& options_;
  std::FILE* out_;
  record::Selection selection_;
  std::map<std::string, record::MessageNode> layouts_;
  std::set<std::string> topics_;
  std::uint64_t printed_ = 0;
};

}  // namespace

int echo_recording(const std::string& file, const EchoOptions& options, std::FILE* out,
                   std::FILE* err) {
  auto recording = record::Recording::open(file);
  if (!recording) {
    fmt::print(err, "topic: {}\n", recording.error().line);
    return terminal::exit_failed;
  }
  RecordedEcho echo(options, out);
  while (const auto event = echo.full() ? std::nullopt : recording->next())
    if (const auto* message = std::get_if<record::Understood>(&*event)) echo.hear(*message);
  if (echo.printed() > 0) return terminal::exit_success;
  fmt::print(err, "topic: nothing of {} in it; it has {}\n", options.name,
             fmt::join(echo.topics(), ", "));
  return terminal::exit_failed;
}

}  // namespace drydock::topic
