#include "rig_config/device_description/requests.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "drivers/wire/hex.hpp"
#include "rig_config/toml/read_keys.hpp"

namespace drydock::rig_config {

namespace described = wire::described;

std::optional<std::string> hex_bytes(std::string text) {
  std::erase(text, ' ');
  std::vector<std::uint8_t> bytes(text.size() / 2);
  if (!wire::parse_hex_bytes(text, bytes)) return {};
  return std::string(bytes.begin(), bytes.end());
}

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
    const auto bytes = hex ? hex_bytes(hex->text) : std::optional(text ? text->text : "");
    if (hex && (!bytes || bytes->empty())) add(*hex, path, "expected pairs of hexadecimal digits");
    described::Request request{bytes.value_or(""), {}, {}};
    read(table, "reply", request.reply);
    read(table, "refusal", request.refusal);
    for (const char* key : {"reply", "refusal"})
      if (const Node* word = table.find(key);
          word &&
          std::ranges::find(messages, word->text, &described::Message::name) == messages.end())
        add(*word, path + "/" + key, fmt::format("no message is called \"{}\"", word->text));
    if (const Node* no = table.find("refusal"); no && request.refusal == request.reply)
      add(*no, path + "/refusal", "the message that agrees cannot refuse");
    requests.push_back(std::move(request));
  });
  return requests;
}

}  // namespace drydock::rig_config
