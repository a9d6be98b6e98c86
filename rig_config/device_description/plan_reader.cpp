#include "rig_config/device_description/plan_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rig_config/device_description/field_reader.hpp"
#include "rig_config/device_description/field_relations.hpp"
#include "rig_config/device_description/frame_messages.hpp"
#include "rig_config/device_description/frame_reader.hpp"
#include "rig_config/device_description/message_head.hpp"
#include "rig_config/device_description/pattern_reader.hpp"
#include "rig_config/device_description/protocol_keys.hpp"
#include "rig_config/device_description/requests.hpp"
#include "rig_config/rules/explain.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {
namespace {

namespace described = wire::described;
using described::Description;
using described::Field;
using described::Form;
using described::Message;
using described::Plan;
using described::Type;

class PlanReader {
 public:
  PlanReader(const Node& root, const std::string& file, Problems& problems)
      : root_(root), protocol_(*root.find("protocol")), file_(file), problems_(problems) {}

  Description run() {
    const Node& sensor = *root_.find("sensor");
    read(sensor, "title", description_.title);
    if (const Node* kind = sensor.find("kind"))
      description_.kind = measurement::kind_of(kind->text).value();
    if (const auto wait = read_if(sensor, "reply_within_ms"))
      description_.reply_within = std::chrono::milliseconds{static_cast<std::int64_t>(*wait)};
    if (const Node* messages = the_messages()) {
      if (plan().form == Form::frames) frames_ = plan_frames(root_, description_, file_, problems_);
      if (plan().form == Form::frames ? !frames_ : has_dbc_in_vain())
        return std::move(description_);
      read_protocol_keys(protocol_, plan(), file_, problems_);
      for (std::size_t i = 0; i < messages->items.size(); ++i) read_message(messages->items[i], i);
      if (problems_.empty()) finish(*messages);
    }
    description_.start = read_requests(root_, "start", description_, file_, problems_);
    answer_as_wanted(plan(), description_.start);
    description_.poll = read_requests(root_, "poll", description_, file_, problems_);
    return std::move(description_);
  }

 private:
  const Node* the_messages() {
    const Node* found = nullptr;
    for (const auto& [word, form] :
         {std::pair("sentences", Form::sentences), std::pair("binary", Form::binary),
          std::pair("lines", Form::lines), std::pair("frames", Form::frames)}) {
      const Node* one = protocol_.find(word);
      if (!one) continue;
      if (found) add(*one, path_, "a protocol has one of: sentences, binary, lines, frames");
      found = one;
      plan().form = form;
      path_ = std::string("/protocol/") + word;
    }
    if (!found)
      add(protocol_, "/protocol", "a protocol needs one of: sentences, binary, lines, frames");
    return found;
  }

  bool has_dbc_in_vain() {
    const Node* word = protocol_.find("dbc");
    if (word)
      add(*word, "/protocol/dbc", "a DBC file describes frames; allowed: [[protocol.frames]]");
    return word != nullptr;
  }

  /// Fields in their order need another separator; a pattern has none.
  void check_decimal(const Node& table, const std::string& path) {
    if (plan().decimal_comma && separator_of(protocol_) == ',' && !table.find("pattern"))
      add(*protocol_.find("decimal"), path,
          "the comma of the decimals is the separator too; allowed: separator = another character");
  }

  void read_message(const Node& table, std::size_t i) {
    const std::string path = fmt::format("{}/{}", path_, i);
    Message message;
    read_head(table, path, message);
    check_decimal(table, path);
    read(table, "name", message.name);
    check_name(table, path, message);
    message.first_field = static_cast<std::uint16_t>(plan().fields.size());
    read_fields(table, path, message);
    check_begin(table, path, message);
    const bool emulated = !table.find("emulated") || table.find("emulated")->boolean;
    const bool can_be_written = !table.find("pattern") || table.find("emulate");
    message.emulated = emulated && can_be_written && (message.publishes || has_constant(table));
    read_same_as(table, path, message);
    if (plan().form != Form::frames) read_sample(table, path, message);
    plan().messages.push_back(std::move(message));
  }

  /// True for a message of frames of which a field says what the emulated device writes.
  bool has_constant(const Node& table) const {
    const Node* fields = plan().form == Form::frames ? table.find("fields") : nullptr;
    return fields &&
           std::ranges::any_of(fields->items, [](const Node& one) { return one.find("emulate"); });
  }

  void read_same_as(const Node& table, const std::string& path, Message& message) {
    const Node* other = table.find("same_as");
    if (!other) return;
    const auto& above = plan().messages;
    const auto found = std::ranges::find(above, other->text, &Message::name);
    if (found == above.end())
      return add(*other, path + "/same_as",
                 fmt::format("no message above is called \"{}\"", other->text));
    message.same_as = static_cast<std::uint16_t>(found - above.begin());
  }

  /// A message follows the last one above it that has its sample.
  void read_sample(const Node& table, const std::string& path, Message& message) {
    const Node* sample = table.find("sample");
    samples_.push_back(sample ? sample->text : "");
    if (!sample) return;
    if (message.same_as)
      add(*sample, path + "/sample", "a message with 'same_as' is a sample of its own");
    for (std::size_t i = plan().messages.size(); i-- > 0;) {
      if (samples_[i] != sample->text) continue;
      message.follows = static_cast<std::uint16_t>(i);
      plan().messages[i].leads = true;
      return;
    }
  }

  void check_name(const Node& table, const std::string& path, const Message& message) {
    const auto& others = plan().messages;
    if (message.name.empty())
      add(table, path, "key 'name' is missing");
    else if (std::ranges::find(others, message.name, &Message::name) != others.end())
      add(table, path,
          fmt::format("two messages are called \"{}\"; give one a 'name'", message.name));
  }

  void read_head(const Node& table, const std::string& path, Message& message) {
    if (plan().form == Form::frames) {
      message.name = frames_->frames[plan().messages.size()].message.long_name;
      return;
    }
    if (plan().form == Form::binary) {
      return read_binary_head(protocol_, table, plan(), message, file_, path, problems_);
    }
    read_text_head(protocol_, table, plan(), message, file_, path, problems_);
  }

  /// Something has to tell where a frame begins.
  void check_begin(const Node& table, const std::string& path, const Message& message) {
    const bool constant = std::ranges::any_of(
        plan().fields_of(message), [](const Field& field) { return field.type == Type::constant; });
    if (plan().form == Form::binary && message.head.empty() && !constant && !table.find("sync"))
      add(table, path, "a frame needs 'sync', or a constant field ('is') that tells what it is");
  }

  void read_fields(const Node& table, const std::string& path, Message& message) {
    const Node* fields = table.find("fields");
    const std::size_t count = fields ? fields->items.size() : 0;
    const auto line = read_pattern(table, file_, path, problems_);
    if (table.find("pattern") && !line) return;
    std::vector<Field> read;
    for (std::size_t i = 0; i < count; ++i) {
      const FieldContext context{
          plan().form,
          description_.kind,
          separator_of(protocol_),
          order_of(protocol_),
          file_,
          fmt::format("{}/fields/{}", path, i),
          frames_ ? &frames_->frames[plan().messages.size()].message : nullptr,
          line ? &line->pattern.groups() : nullptr,
          message.records ? &*message.records : nullptr};
      read.push_back(read_field(fields->items[i], context, problems_));
      message.publishes |= read.back().target && !described::is_time(*read.back().target);
    }
    const bool in_order = plan().form != Form::frames && !line;
    if (fields) relate_fields(fields->items, in_order, read, file_, path, problems_);
    if (line) read_written(table, read, *line, file_, path, problems_);
    message.line = line;
    message.divides =
        std::ranges::any_of(read, [](const Field& f) { return f.divisor.has_value(); });
    message.has_signs =
        std::ranges::any_of(read, [](const Field& f) { return f.type == Type::sign; });
    message.has_parts = std::ranges::any_of(read, &Field::has_parts);
    message.fields = static_cast<std::uint16_t>(count);
    message.mapped = mapped(read);
    if (frames_)
      read_frame(table, read, frames_->frames[plan().messages.size()], file_, path, problems_);
    std::ranges::move(read, std::back_inserter(plan().fields));
  }

  /// What only the whole plan tells.
  void finish(const Node& messages) {
    if (frames_) {
      for (Problem& one : check_samples(plan(), *frames_, messages.items, file_))
        problems_.push_back(std::move(one));
      limit_samples(protocol_, *frames_);
      description_.frames = frames_;
    } else {
      for (const Message& message : plan().messages) note_starts(message);
      note_encapsulation();
      plan().texts = described::FlatTexts(plan());
      for (Problem& one : check_plan(plan(), messages.items, file_, path_))
        problems_.push_back(std::move(one));
      for (Problem& one : check_emulated(plan(), messages.items, file_, path_))
        problems_.push_back(std::move(one));
    }
    for (Problem& one : check_whole(description_, messages.items, file_, path_))
      problems_.push_back(std::move(one));
    if (description_.kind && std::ranges::none_of(plan().messages, &Message::publishes))
      add(messages, path_, "no field is part of a measurement: none has the key 'field'");
  }

  void note_starts(const Message& message) {
    const bool any = message.head.empty() || plan().stuffing != described::Stuffing::none;
    const bool binary = plan().form == Form::binary;
    for (unsigned c = 0; c < 256; ++c)
      plan().starts[c] =
          plan().starts[c] || (any ? binary || (c > 0x20 && c < 0x7F)
                                   : c == static_cast<unsigned char>(message.head[0]));
  }

  /// On a line with sentences of NMEA 0183 those that begin with `!` have the same checksum.
  void note_encapsulation() {
    const bool sentences = plan().form == Form::sentences && plan().starts['$'];
    if (sentences && plan().checksum.name() == "xor" && plan().checksum_from == 1)
      plan().starts['!'] = true;
  }

  Plan& plan() { return description_.plan; }
  const Plan& plan() const { return description_.plan; }
  void add(const Node& at, const std::string& path, std::string what) {
    problems_.push_back({file_, at.at.line, at.at.column, path, std::move(what)});
  }

  const Node& root_;
  const Node& protocol_;
  const std::string& file_;
  Problems& problems_;
  Description description_;
  std::string path_ = "/protocol";
  std::vector<std::string> samples_;              ///< the sample of each message of bytes
  std::shared_ptr<described::FramePlan> frames_;  ///< of a DBC file
};

}  // namespace

Description read_description(const Node& root, const std::string& file, Problems& problems) {
  return PlanReader(root, file, problems).run();
}

}  // namespace drydock::rig_config
