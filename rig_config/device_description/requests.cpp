#include "rig_config/device_description/requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "drivers/wire/hex.hpp"
#include "rig_config/device_description/request_checksum.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

namespace described = wire::described;

std::optional<std::string> hex_bytes(std::string text) {
  std::erase(text, ' ');
  std::vector<std::uint8_t> bytes(text.size() / 2);
  if (!wire::parse_hex_bytes(text, bytes)) return {};
  return std::string(bytes.begin(), bytes.end());
}

namespace {

/// `says = { unit = 1 }`: fields of the reply and the numbers that they must have.
template <class Add>
void read_says(std::string_view group, const Node& table, const std::string& path,
               const described::Description& of, described::Request& request, Add&& add) {
  const Node* says = table.find("says");
  if (!says) return;
  if (group != "start") return add(*says, path + "/says", "only for requests of the start");
  const auto& messages = of.plan.messages;
  const auto reply = std::ranges::find(messages, request.reply, &described::Message::name);
  if (reply == messages.end()) return add(*says, path + "/says", "it needs a 'reply'");
  const auto fields = of.plan.fields_of(*reply);
  for (const auto& [key, number] : says->members) {
    if (std::ranges::find(fields, key, &described::Field::key) == fields.end())
      add(number, path + "/says", fmt::format("{} has no field \"{}\"", request.reply, key));
    if (number.kind != Node::Kind::number && number.kind != Node::Kind::integer)
      add(number, path + "/says", fmt::format("{} must be a number", key));
    request.says.push_back({key, number.number});
  }
}

}  // namespace

std::vector<described::Request> read_requests(const Node& root, const char* group,
                                              const described::Description& description,
                                              const std::string& file, Problems& problems) {
  const auto add = [&](const Node& at, const std::string& path, std::string what) {
    problems.push_back({file, at.at.line, at.at.column, path, std::move(what)});
  };
  const auto& messages = description.plan.messages;
  std::vector<described::Request> requests;
  for_each_table(root, group, [&](const Node& table, std::size_t i) {
    const std::string path = fmt::format("/{}/{}", group, i);
    const Node* text = table.find("send");
    const Node* hex = table.find("send_hex");
    if ((text != nullptr) == (hex != nullptr)) add(table, path, "one of: 'send', 'send_hex'");
    auto bytes = hex ? hex_bytes(hex->text) : std::optional(text ? text->text : "");
    if (hex && (!bytes || bytes->empty())) add(*hex, path, "expected pairs of hexadecimal digits");
    if (const Node* sum = table.find("checksum"); sum && sum->boolean && bytes) {
      const auto why_not = add_checksum(description.plan, *bytes);
      if (!why_not.empty()) add(*sum, path + "/checksum", std::string(why_not));
    }
    described::Request request{.bytes = bytes.value_or(""), .reply = {}, .refusal = {}, .says = {}};
    read(table, "reply", request.reply);
    read(table, "refusal", request.refusal);
    for (const char* key : {"reply", "refusal"})
      if (const Node* word = table.find(key);
          word &&
          std::ranges::find(messages, word->text, &described::Message::name) == messages.end())
        add(*word, path + "/" + key, fmt::format("no message is called \"{}\"", word->text));
    if (const Node* no = table.find("refusal"); no && request.refusal == request.reply)
      add(*no, path + "/refusal", "the message that agrees cannot refuse");
    read_says(group, table, path, description, request, add);
    requests.push_back(std::move(request));
  });
  return requests;
}

void answer_as_wanted(described::Plan& plan, const std::vector<described::Request>& requests) {
  for (const auto& request : requests)
    for (const auto& wanted : request.says) {
      const auto reply = std::ranges::find(plan.messages, request.reply, &described::Message::name);
      if (reply == plan.messages.end()) continue;
      const auto fields = std::span(plan.fields).subspan(reply->first_field, reply->fields);
      const auto field = std::ranges::find(fields, wanted.field, &described::Field::key);
      if (field != fields.end() && field->idle == 0) field->idle = wanted.value;
    }
}

}  // namespace drydock::rig_config
