#include <fmt/format.h>

#include <boost/throw_exception.hpp>
#include <stdexcept>

#include "hil/cli/replay/references.hpp"

namespace drydock::cli {

namespace {
constexpr int references_version = 1;
}  // namespace

void throw_exception_from_error(const ReferencesError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.line), where);
}

std::string to_json_text(const References& references) {
  std::string text = fmt::format("{{\"drydock_references\": {},\n\"part\": {},\n\"topics\": {{",
                                 references_version, ReferenceValue(references.part).dump());
  const char* before_topic = "\n";
  for (const auto& [name, topic] : references.topics) {
    text += fmt::format(
        "{}{}: {{\"type\": {}, \"messages\": {}, \"every\": {}, \"digest\": \"{}\", \"rows\": [",
        before_topic, ReferenceValue(name).dump(), ReferenceValue(topic.type).dump(),
        topic.messages, topic.every, topic.digest);
    const char* before_row = "\n";
    for (const auto& row : topic.rows) {
      text +=
          fmt::format("{}[{}, \"{}\", {}]", before_row, row.at_ns, row.digest, row.values.dump());
      before_row = ",\n";
    }
    text += "]}";
    before_topic = ",\n";
  }
  return text + "}}\n";
}

boost::system::result<References, ReferencesError> parse_references(const std::string& text) {
  try {
    const ReferenceValue file = ReferenceValue::parse(text);
    if (file.at("drydock_references") != references_version)
      return ReferencesError{fmt::format("references of version {}, this program reads {}",
                                         file.at("drydock_references").dump(), references_version)};
    References references;
    references.part = file.at("part").get<std::string>();
    for (const auto& [name, from] : file.at("topics").items()) {
      auto& topic = references.topics[name];
      topic = {from.at("type"), from.at("messages"), from.at("every"), from.at("digest"), {}};
      if (topic.every == 0) return ReferencesError{name + ": every is 0"};
      for (const auto& row : from.at("rows"))
        topic.rows.push_back({row.at(0), row.at(1), row.at(2)});
    }
    return references;
  } catch (const ReferenceValue::exception& error) {
    return ReferencesError{std::string("no references of a replay: ") + error.what()};
  }
}

}  // namespace drydock::cli
