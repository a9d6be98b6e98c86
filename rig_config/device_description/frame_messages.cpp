#include "rig_config/device_description/frame_messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "drivers/measurement/units.hpp"
#include "drivers/wire/dbc/same_frame.hpp"
#include "rig_config/device_description/dbc_source.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace dbc = wire::dbc;
namespace described = wire::described;

constexpr const char* tables_path = "/protocol/frames";

class FrameMessages {
 public:
  FrameMessages(const Node& root, const std::string& file, Problems& problems)
      : root_(root), protocol_(*root.find("protocol")), file_(file), problems_(problems) {}

  std::shared_ptr<described::FramePlan> plan(described::Description& description) {
    refuse_keys_of_bytes();
    const Node& tables = *protocol_.find("frames");
    const Node* word = protocol_.find("dbc");
    if (!word) add(tables, tables_path, "frames need the key 'dbc' of [protocol]: a DBC file");
    const auto database =
        word ? find_dbc(*word, file_, description.dbc_file, problems_) : std::nullopt;
    dbc::Database used;
    for (std::size_t i = 0; database && i < tables.items.size(); ++i)
      use_message(tables.items[i], i, *database, used);
    refuse_same_frames(tables, used);
    return problems_.empty() ? std::make_shared<described::FramePlan>(used) : nullptr;
  }

 private:
  void refuse_keys_of_bytes() {
    for (const char* key :
         {"checksum", "checksum_from", "checksum_order", "checksum_optional", "order", "separator",
          "longest", "end", "checksum_at", "checksum_extra", "header_checksum", "stuffing"})
      if (const Node* one = protocol_.find(key))
        add(*one, std::string("/protocol/") + key, "only for bytes: the DBC file describes frames");
    for (const char* key : {"start", "poll"})
      if (const Node* one = root_.find(key))
        add(*one, std::string("/") + key, "only for bytes: a driver of frames says nothing");
  }

  void use_message(const Node& table, std::size_t i, const dbc::Database& database,
                   dbc::Database& used) {
    const Node& word = *table.find("message");
    const std::string path = fmt::format("{}/{}/message", tables_path, i);
    const dbc::Message* message = database.find(word.text);
    if (!message) return refuse_message(word, path, database);
    if (used.find(message->name)) add(word, path, "this message has a table already");
    const unsigned most = message->format == dbc::FrameFormat::fd ? 64 : 8;
    if (message->size > most)
      add(word, path,
          fmt::format("message {} has {} bytes, allowed: up to {}, which one frame holds{}",
                      message->long_name, message->size, most, advice_of(*message)));
    used.messages.push_back(*message);
  }

  void refuse_same_frames(const Node& tables, const dbc::Database& used) {
    if (used.messages.size() != tables.items.size()) return;
    for (const auto& [first, second] : dbc::same_frames(used.messages)) {
      const Node& word = *tables.items[second].find("message");
      if (used.messages[first].name != used.messages[second].name)
        add(word, fmt::format("{}/{}/message", tables_path, second),
            fmt::format("the DBC file gives {} the identifier of {} of line {}: no frame tells "
                        "which of them it is, allowed: one of the two",
                        used.messages[second].long_name, used.messages[first].long_name,
                        tables.items[first].at.line));
    }
  }

  /// Many files have messages of CAN FD and do not say so.
  static std::string_view advice_of(const dbc::Message& message) {
    if (message.format != dbc::FrameFormat::classic || message.size > 64) return {};
    return "; of a frame of CAN FD the DBC file says so: attribute VFrameFormat, 14 "
           "(StandardCAN_FD) or 15 (ExtendedCAN_FD)";
  }

  void refuse_message(const Node& word, const std::string& path, const dbc::Database& database) {
    std::vector<std::string> names;
    names.reserve(database.messages.size());
    for (const dbc::Message& one : database.messages) names.push_back(one.long_name);
    add(word, path,
        fmt::format("the DBC file has no message \"{}\"{}, allowed: {}", word.text,
                    did_you_mean(word.text, names), listed(names)));
  }

  void add(const Node& at, const std::string& path, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, path, std::move(what)});
  }

  const Node& root_;
  const Node& protocol_;
  const std::string& file_;
  Problems& problems_;
};

}  // namespace

std::shared_ptr<described::FramePlan> plan_frames(const Node& root,
                                                  described::Description& description,
                                                  const std::string& file, Problems& problems) {
  return FrameMessages(root, file, problems).plan(description);
}

void limit_samples(const Node& protocol, described::FramePlan& frames) {
  using std::chrono::microseconds;
  constexpr std::chrono::seconds unknown_cycle{1};
  std::optional<microseconds> burst;
  std::chrono::nanoseconds in_turn{0};
  for (const auto& one : frames.frames) {
    const microseconds half(500 * one.message.cycle_ms);
    if (half.count() != 0) burst = std::min(burst.value_or(half), half);
    const auto turns = static_cast<int>(one.waited_turns);
    if (turns > 1 && half.count() == 0) in_turn = unknown_cycle;
    if (turns > 1) in_turn = std::max<std::chrono::nanoseconds>(in_turn, half * (2 * turns - 1));
  }
  if (burst) frames.longest_sample = *burst;
  frames.longest_sample = std::max(frames.longest_sample, in_turn);
  if (const auto within = read_if(protocol, "within_ms", millisecond))
    frames.longest_sample = std::chrono::nanoseconds{std::llround(*within * 1e9)};
}

}  // namespace drydock::rig_config
