#include "drivers/wire/dbc/annotations.hpp"

#include <algorithm>

#include "drivers/wire/dbc/keywords.hpp"
#include "drivers/wire/dbc/reader.hpp"
#include "drivers/wire/dbc/signal_line.hpp"

namespace drydock::wire::dbc {
namespace {

constexpr std::string_view nobody = "Vector__XXX";
constexpr std::uint32_t id_of_orphans = 0xC000'0000;

/// True for what may stand as a name in the file, as long as it may be.
bool is_name(std::string_view text) { return !text.empty() && Scanner(text).next_word() == text; }

}  // namespace

std::uint32_t read_identifier(Scanner& in) {
  return static_cast<std::uint32_t>(in.bounded("the identifier", 0, 0xFFFF'FFFF));
}

void add_sender(Message& m, std::string_view name) {
  if (name == nobody || std::ranges::find(m.senders, name) != m.senders.end()) return;
  m.senders.emplace_back(name);
}

void Annotations::more_senders() {
  const auto place = referred_message();
  in_.expect(':');
  while (next_is_name(in_)) {
    const std::string_view name = in_.word("a sender");
    if (place) add_sender(contents_.database.messages[*place], name);
    in_.accept(',');
  }
  end_statement();
}

void Annotations::end_statement() {
  if (in_.accept(';')) return;
  if (!in_.at_statement_end()) in_.fail("';' is missing");
  contents_.remarks.warn(in_.place(), "';' is missing");
}

/// The message of a reference. Empty for the orphans, or after a warning.
std::optional<std::size_t> Annotations::referred_message() {
  const Place at = in_.place();
  const std::uint32_t id = read_identifier(in_);
  const auto found = contents_.places.find(id);
  if (found != contents_.places.end()) return found->second;
  if (id == id_of_orphans) return std::nullopt;
  if (!complete_) throw TooEarly{};
  contents_.remarks.warn(at, "no message has this identifier");
  return std::nullopt;
}

std::optional<Annotations::Found> Annotations::referred_signal() {
  return referred_signal(referred_message());
}

std::optional<Annotations::Found> Annotations::referred_signal(std::optional<std::size_t> place) {
  const Place at = in_.place();
  const std::string name{in_.word("a signal")};
  if (!place) return std::nullopt;
  auto& signals = contents_.database.messages[*place].signals;
  const auto found = std::ranges::find(signals, name, &Signal::name);
  if (found == signals.end()) {
    contents_.remarks.warn(
        at, "message " + contents_.database.messages[*place].name + " has no signal " + name);
    return std::nullopt;
  }
  return Found{*place, &*found, &contents_.choices[*place][std::size_t(found - signals.begin())]};
}

Node* Annotations::node(std::string_view name) {
  const auto found = std::ranges::find(contents_.database.nodes, name, &Node::name);
  return found != contents_.database.nodes.end() ? &*found : nullptr;
}

/// Where the comment on a signal goes; nowhere if it names none, as some files have it.
std::string* Annotations::comment_of_signal() {
  const auto place = referred_message();
  if (in_.next_is('"')) {
    contents_.remarks.warn(in_.place(), "the comment names no signal");
    return nullptr;
  }
  const auto found = referred_signal(place);
  return found ? &found->signal->comment : nullptr;
}

void Annotations::comment() {
  const std::string_view object = in_.next_is('"') ? "" : in_.word("what the comment is about");
  std::string* text = nullptr;
  if (object == "BU_") {
    if (Node* n = node(in_.word("a node"))) text = &n->comment;
  } else if (object == "BO_") {
    if (const auto place = referred_message()) text = &contents_.database.messages[*place].comment;
  } else if (object == "SG_") {
    text = comment_of_signal();
  } else if (!object.empty()) {
    in_.word("what the comment is about");
  }
  const std::string content = in_.string("the comment");
  if (text) *text = content;
  end_statement();
}

void Annotations::attribute() {
  const std::string name = in_.string("the attribute's name");
  const std::string_view object = in_.next_is('"') ? "" : object_word();
  std::string* long_name = nullptr;
  std::optional<std::size_t> place;
  if (object == "BU_") {
    if (Node* n = node(in_.word("a node"))) long_name = &n->long_name;
  } else if (object == "BO_") {
    place = referred_message();
    if (place) long_name = &contents_.database.messages[*place].long_name;
  } else if (object == "SG_") {
    if (const auto found = referred_signal()) long_name = &found->signal->long_name;
  } else if (object == "EV_") {
    in_.word("a variable");
  }
  AttributeValue value = Attributes::read_value(in_);
  end_statement();
  if (name.starts_with("System") && name.ends_with("LongSymbol")) {
    if (long_name && is_name(value.text)) *long_name = value.text;
  } else if (place) {
    contents_.attributes.set(*place, name, std::move(value));
  }
}

/// A number may follow the name at once.
std::string_view Annotations::object_word() {
  const std::string_view next = in_.next_word();
  const bool object = next == "BU_" || next == "BO_" || next == "SG_" || next == "EV_";
  return object ? in_.word("an object") : "";
}

void Annotations::labels() {
  const std::string_view next = in_.next_word();
  const bool of_variable = next.empty() || next.front() < '0' || next.front() > '9';
  if (of_variable) {
    in_.skip_to_statement_end();
    return end_statement();
  }
  const auto found = referred_signal();
  std::vector<Label> all;
  while (!in_.at_statement_end()) {
    const Place at = in_.place();
    const auto raw = in_.raw_value("the raw value");
    std::string text = in_.string("the value's name");
    if (raw) {
      all.push_back({*raw, std::move(text)});
    } else {
      contents_.remarks.warn(at, "no raw value is this number, so the name is never told");
    }
  }
  end_statement();
  if (found) found->signal->labels = std::move(all);
}

void Annotations::value_type() {
  const auto found = referred_signal();
  in_.accept(':');
  const Place at = in_.place();
  const auto type = in_.bounded("the type", 0, 2);
  end_statement();
  if (!found || type == 0) return;
  if (found->signal->layout.bits != 32 * type)
    throw Unreadable{{at, "a floating-point number has 32 bits (1) or 64 bits (2)"}};
  found->signal->layout.number = type == 1 ? Number::float32 : Number::float64;
}

void Annotations::multiplexed_values() {
  const auto found = referred_signal();
  const std::string selector{in_.word("the selector")};
  std::vector<Range> ranges;
  while (!in_.at_statement_end()) {
    const Place at = in_.place();
    const std::int64_t first = in_.integer("the first value");
    ranges.push_back({first, in_.accept('-') ? in_.integer("the last value") : first});
    if (ranges.back().last < first)
      contents_.remarks.warn(at, "the range ends before it begins, so no value is in it");
    in_.accept(',');
  }
  end_statement();
  if (!found) return;
  found->choice->selector = selector;
  found->choice->ranges = std::move(ranges);
  if (found->choice->ranges.empty()) in_.fail("SG_MUL_VAL_ has no values");
}

}  // namespace drydock::wire::dbc
