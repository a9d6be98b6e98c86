#include <fmt/format.h>

#include <algorithm>
#include <boost/throw_exception.hpp>
#include <stdexcept>

#include "hil/replay/reference/references.hpp"

#include "drivers/text/json_of_any_text.hpp"

namespace drydock::replay {

namespace {
constexpr int references_version = 1;
}  // namespace

void throw_exception_from_error(const ReferencesError& error, const boost::source_location& where) {
  boost::throw_exception(std::runtime_error(error.line), where);
}

std::string to_json_text(const References& references) {
  std::string text =
      fmt::format("{{\"drydock_references\": {},\n\"part\": {},\n\"topics\": {{",
                  references_version, text::json_of_any_text(ReferenceValue(references.part), -1));
  const char* before_topic = "\n";
  for (const auto& [name, topic] : references.topics) {
    text += fmt::format(
        "{}{}: {{\"type\": {}, \"messages\": {}, \"every\": {}, \"digest\": \"{}\", \"rows\": [",
        before_topic, text::json_of_any_text(ReferenceValue(name), -1),
        text::json_of_any_text(ReferenceValue(topic.type), -1), topic.messages, topic.every,
        topic.digest);
    const char* before_row = "\n";
    for (const auto& row : topic.rows) {
      text += fmt::format("{}[{}, \"{}\", {}]", before_row, row.at_ns, row.digest,
                          text::json_of_any_text(row.values, -1));
      before_row = ",\n";
    }
    text += "]}";
    before_topic = ",\n";
  }
  return text + "}}\n";
}

namespace {

/// Accepts only whole numbers: the conversion of 1e300 to an integer has no defined value.
template <class Integer>
Integer integer_at(const ReferenceValue& object, const ReferenceValue& value, const char* what) {
  if (!value.is_number_integer() || (std::is_unsigned_v<Integer> && !value.is_number_unsigned()))
    throw ReferenceValue::type_error::create(302, std::string(what) + " must be a whole number",
                                             &object);
  return value.get<Integer>();
}

ReferenceRow row_of(const ReferenceValue& row) {
  const ReferenceValue& values = row.at(2);
  const auto nested = [](const ReferenceValue& value) { return value.is_structured(); };
  if (!values.is_array() || std::ranges::any_of(values, nested))
    throw ReferenceValue::type_error::create(302, "a row's values must be a list of values", &row);
  return {integer_at<std::int64_t>(row, row.at(0), "a row's time"), row.at(1), values};
}

ReferenceTopic topic_of(const ReferenceValue& from) {
  const auto count = [&](const char* key) {
    return integer_at<std::uint64_t>(from, from.at(key), key);
  };
  ReferenceTopic topic{from.at("type"), count("messages"), count("every"), from.at("digest"), {}};
  for (const auto& row : from.at("rows")) topic.rows.push_back(row_of(row));
  return topic;
}

}  // namespace

boost::system::result<References, ReferencesError> parse_references(const std::string& text) {
  try {
    const ReferenceValue file = ReferenceValue::parse(text);
    if (file.at("drydock_references") != references_version)
      return ReferencesError{fmt::format("references of version {}, this program reads {}",
                                         text::json_of_any_text(file.at("drydock_references"), -1),
                                         references_version)};
    References references;
    references.part = file.at("part").get<std::string>();
    for (const auto& [name, from] : file.at("topics").items()) {
      const auto& topic = references.topics[name] = topic_of(from);
      if (topic.every == 0) return ReferencesError{name + ": every is 0"};
    }
    return references;
  } catch (const ReferenceValue::exception& error) {
    return ReferencesError{std::string("no references of a replay: ") + error.what()};
  }
}

}  // namespace drydock::replay
