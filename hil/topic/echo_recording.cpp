#include <fmt/format.h>

#include <set>

#include "drivers/recordings/record/layouts.hpp"
#include "drivers/recordings/record/selection.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_of_any_text.hpp"
#include "drivers/text/printable.hpp"
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
    const record::Layout& layout = layouts_.of(message);
    if (!layout) return unread_.add(message.channel->topic, layout.error().line);
    if (const auto why = record::misfit(*layout, message.cdr); !why.empty())
      return unread_.add(message.channel->topic, why);
    ++printed_;
    nlohmann::ordered_json line{{"topic", message.channel->topic},
                                {"at_s", measurement::seconds(message.at.time_since_epoch())}};
    for (const auto& [name, value] : replay::values_of(*layout, message.cdr)) line[name] = value;
    fmt::print(out_, "{}\n", text::json_of_any_text(line, -1));
  }
  bool full() const { return options_.most > 0 && printed_ >= options_.most; }
  std::vector<std::string> notes() const { return unread_.notes(); }
  std::uint64_t printed() const { return printed_; }
  const std::set<std::string>& topics() const { return topics_; }

 private:
  bool wants(const record::Understood& message) const {
    return options_.name.starts_with('/') ? message.channel->topic == options_.name
                                          : selection_.takes(*message.channel);
  }

  const EchoOptions& options_;
  std::FILE* out_;
  record::Selection selection_;
  record::Layouts layouts_;
  record::Unread unread_;
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
  const auto notes = echo.notes();
  for (const auto& note : notes) fmt::print(err, "topic: {}\n", text::printable(note));
  if (echo.printed() > 0) return terminal::exit_success;
  if (!notes.empty()) return terminal::exit_failed;
  const auto topics = fmt::format("{}", fmt::join(echo.topics(), ", "));
  fmt::print(err, "topic: {}; it has {}\n",
             options.name.empty() ? "no message in it"
                                  : text::printable("nothing of " + options.name + " in it"),
             topics.empty() ? "no topic" : text::printable(topics));
  return terminal::exit_failed;
}

}  // namespace drydock::topic
