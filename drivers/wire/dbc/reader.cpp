#include "drivers/wire/dbc/reader.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "drivers/wire/dbc/attributes.hpp"
#include "drivers/wire/dbc/keywords.hpp"
#include "drivers/wire/dbc/layout_check.hpp"
#include "drivers/wire/dbc/multiplexing.hpp"
#include "drivers/wire/dbc/scanner.hpp"
#include "drivers/wire/dbc/signal_line.hpp"
#include "drivers/wire/dbc/text_encoding.hpp"

namespace drydock::wire::dbc {

namespace {

constexpr std::uint32_t extended_flag = 0x8000'0000, longest_id = 0x1FFF'FFFF;
constexpr std::uint32_t longest_standard_id = 0x7FF;
constexpr std::string_view orphans = "VECTOR__INDEPENDENT_SIG_MSG";  ///< signals of no message
constexpr std::string_view nobody = "Vector__XXX";

/// True for what may stand as a name in the file, as long as it may be.
bool is_name(std::string_view text) { return !text.empty() && Scanner(text).next_word() == text; }

/// Reads one text. Places of messages and signals are kept until multiplexing is resolved at the
/// end.
class Reader {
 public:
  Reader(std::string_view text, Reading& reading)
      : in_(text), database_(reading.database), remarks_(reading) {}

  void read() {
    while (!in_.at_end()) {
      try {
        statement();
      } catch (const Unreadable& fault) {
        remarks_.error(fault.remark.at, fault.remark.text);
        skip_to_statement();
      }
    }
    finish();
  }

 private:
  struct Statement {
    std::string_view word;
    void (Reader::*read)();
  };
  static const std::array<Statement, 13> statements;

  struct Found {
    std::size_t message = 0;
    Signal* signal = nullptr;
    Choice* choice = nullptr;
  };

  static const Statement* statement_of(std::string_view word) {
    const auto* const found = std::ranges::find(statements, word, &Statement::word);
    return found != statements.end() ? found : nullptr;
  }
  void statement() {
    if (in_.accept(';')) return;
    const std::string_view word = in_.next_word();
    const Statement* known = statement_of(word);
    if (!known && !is_skipped(word))
      in_.fail(word == "SG_" ? "SG_ stands behind no BO_" : "no statement begins so");
    in_.word("a statement");
    known ? (this->*known->read)() : in_.skip_to_semicolon();
  }

  void skip_to_statement() {
    do {
      in_.skip_line();
    } while (!in_.at_end() && (in_.next_word() == "SG_" || !is_keyword(in_.next_word())));
  }

  void version() { in_.string("the version"); }

  /// Keywords without content, indented.
  void new_symbols() {
    in_.accept(':');
    while (!in_.at_end() && !in_.at_margin()) in_.skip_line();
  }

  void bit_timing() {
    in_.accept(':');
    while (!in_.at_end() && !is_keyword(in_.next_word())) in_.skip_line();
  }

  void nodes() {
    in_.expect(':');
    while (next_is_name(in_)) {
      const std::string name{in_.word("a node")};
      database_.nodes.push_back({name, name, {}});
    }
  }

  void message() {
    Message m;
    m.at = in_.place();
    const std::uint32_t id = identifier();
    m.name = m.long_name = in_.word("the message's name");
    in_.expect(':');
    m.size = static_cast<unsigned>(in_.bounded("the number of bytes", 0, most_bytes));
    if (next_is_name(in_)) add_sender(m, in_.word("the sender"));
    std::vector<Choice> choices;
    while (in_.next_word() == "SG_") signal_line(m, choices);
    if (m.name != orphans) add_message(id, std::move(m), std::move(choices));
  }

  std::uint32_t identifier() {
    return static_cast<std::uint32_t>(in_.bounded("the identifier", 0, 0xFFFF'FFFF));
  }

  static void add_sender(Message& m, std::string_view name) {
    if (name == nobody || std::ranges::find(m.senders, name) != m.senders.end()) return;
    m.senders.emplace_back(name);
  }

  void add_message(std::uint32_t id, Message&& m, std::vector<Choice>&& choices) {
    m.id = id & ~extended_flag;
    m.extended = (id & extended_flag) != 0 || m.id > longest_standard_id;
    if (m.id > longest_id) return remarks_.error(m.at, "the identifier has more than 29 bits");
    if (m.extended && (id & extended_flag) == 0)
      remarks_.warn(m.at, "an identifier above 7FFh without bit 31: taken for one of 29 bits");
    if (!places_.try_emplace(id, database_.messages.size()).second)
      remarks_.warn(m.at, "a second message has this identifier; the first one holds");
    database_.messages.push_back(std::move(m));
    choices_.push_back(std::move(choices));
  }

  void signal_line(Message& m, std::vector<Choice>& choices) {
    in_.word("SG_");
    try {
      Choice choice;
      Signal signal = read_signal(in_, choice);
      if (m.signals.size() == most_signals) in_.fail("more than 1024 signals in one message");
      if (m.find(signal.name)) remarks_.warn(signal.at, "a second signal has this name");
      m.signals.push_back(std::move(signal));
      choices.push_back(std::move(choice));
    } catch (const Unreadable& fault) {
      remarks_.error(fault.remark.at, fault.remark.text);
      do {
        in_.skip_line();
      } while (!in_.at_end() && !is_keyword(in_.next_word()));
    }
  }

  /// The message of a reference. Empty for the orphans, or after a warning.
  std::optional<std::size_t> referred_message() {
    const Place at = in_.place();
    const std::uint32_t id = identifier();
    const auto found = places_.find(id);
    if (found != places_.end()) return found->second;
    if (id != 0xC000'0000) remarks_.warn(at, "no message has this identifier");
    return std::nullopt;
  }

  std::optional<Found> referred_signal() {
    const auto place = referred_message();
    const Place at = in_.place();
    const std::string name{in_.word("a signal")};
    if (!place) return std::nullopt;
    auto& signals = database_.messages[*place].signals;
    const auto found = std::ranges::find(signals, name, &Signal::name);
    if (found == signals.end()) {
      remarks_.warn(at, "message " + database_.messages[*place].name + " has no signal " + name);
      return std::nullopt;
    }
    return Found{*place, &*found, &choices_[*place][std::size_t(found - signals.begin())]};
  }

  void more_senders() {
    const auto place = referred_message();
    in_.expect(':');
    while (next_is_name(in_)) {
      const std::string_view name = in_.word("a sender");
      if (place) add_sender(database_.messages[*place], name);
      in_.accept(',');
    }
    in_.expect(';');
  }

  Node* node(std::string_view name) {
    const auto found = std::ranges::find(database_.nodes, name, &Node::name);
    return found != database_.nodes.end() ? &*found : nullptr;
  }

  void comment() {
    const std::string_view object = in_.next_is('"') ? "" : in_.word("what the comment is about");
    std::string* text = nullptr;
    if (object == "BU_") {
      if (Node* n = node(in_.word("a node"))) text = &n->comment;
    } else if (object == "BO_") {
      if (const auto place = referred_message()) text = &database_.messages[*place].comment;
    } else if (object == "SG_") {
      if (const auto found = referred_signal()) text = &found->signal->comment;
    } else if (!object.empty()) {
      in_.word("what the comment is about");
    }
    const std::string content = in_.string("the comment");
    if (text) *text = content;
    in_.expect(';');
  }

  void attribute_definition() { attributes_.define(in_); }
  void attribute_default() { attributes_.set_default(in_); }

  void attribute() {
    const std::string name = in_.string("the attribute's name");
    const std::string_view object = in_.next_is('"') ? "" : object_word();
    std::string* long_name = nullptr;
    std::optional<std::size_t> place;
    if (object == "BU_") {
      if (Node* n = node(in_.word("a node"))) long_name = &n->long_name;
    } else if (object == "BO_") {
      place = referred_message();
      if (place) long_name = &database_.messages[*place].long_name;
    } else if (object == "SG_") {
      if (const auto found = referred_signal()) long_name = &found->signal->long_name;
    } else if (object == "EV_") {
      in_.word("a variable");
    }
    AttributeValue value = Attributes::read_value(in_);
    in_.expect(';');
    if (name.starts_with("System") && name.ends_with("LongSymbol")) {
      if (long_name && is_name(value.text)) *long_name = value.text;
    } else if (place) {
      attributes_.set(*place, name, std::move(value));
    }
  }

  /// A number may follow the name at once.
  std::string_view object_word() {
    const std::string_view next = in_.next_word();
    const bool object = next == "BU_" || next == "BO_" || next == "SG_" || next == "EV_";
    return object ? in_.word("an object") : "";
  }

  void labels() {
    const std::string_view next = in_.next_word();
    const bool of_variable = next.empty() || next.front() < '0' || next.front() > '9';
    if (of_variable) return in_.skip_to_semicolon();
    const auto found = referred_signal();
    std::vector<Label> all;
    while (!in_.next_is(';')) {
      const std::int64_t raw = in_.integer("the raw value");
      all.push_back({raw, in_.string("the value's name")});
    }
    in_.expect(';');
    if (found) found->signal->labels = std::move(all);
  }

  void value_type() {
    const auto found = referred_signal();
    in_.accept(':');
    const Place at = in_.place();
    const auto type = in_.bounded("the type", 0, 2);
    in_.expect(';');
    if (!found || type == 0) return;
    if (found->signal->layout.bits != 32 * type)
      throw Unreadable{{at, "a floating-point number has 32 bits (1) or 64 bits (2)"}};
    found->signal->layout.number = type == 1 ? Number::float32 : Number::float64;
  }

  void multiplexed_values() {
    const auto found = referred_signal();
    const std::string selector{in_.word("the selector")};
    std::vector<Range> ranges;
    while (!in_.next_is(';')) {
      const std::int64_t first = in_.integer("the first value");
      in_.expect('-');
      ranges.push_back({first, in_.integer("the last value")});
      in_.accept(',');
    }
    in_.expect(';');
    if (!found) return;
    found->choice->selector = selector;
    found->choice->ranges = std::move(ranges);
    if (found->choice->ranges.empty()) in_.fail("SG_MUL_VAL_ has no values");
  }

  void finish() {
    for (std::size_t i = 0; i < database_.messages.size(); ++i) {
      Message& m = database_.messages[i];
      const double format = attributes_.of(i, Attributes::frame_format).value_or(0);
      if (format == 3 && m.extended) m.format = FrameFormat::j1939;
      if (format == 14 || format == 15) m.format = FrameFormat::fd;
      const double cycle = attributes_.of(i, Attributes::cycle_time).value_or(0);
      if (cycle > 0 && cycle < 1e9) m.cycle_ms = static_cast<unsigned>(cycle);
      resolve_multiplexing(m, choices_[i], remarks_);
      check_layout(m, remarks_);
    }
  }

  Scanner in_;
  Database& database_;
  Remarks remarks_;
  Attributes attributes_;
  std::unordered_map<std::uint32_t, std::size_t> places_;  ///< by the identifier as written
  std::vector<std::vector<Choice>> choices_;               ///< beside the messages' signals
};

const std::array<Reader::Statement, 13> Reader::statements{
    {{"VERSION", &Reader::version},
     {"NS_", &Reader::new_symbols},
     {"BS_", &Reader::bit_timing},
     {"BU_", &Reader::nodes},
     {"BO_", &Reader::message},
     {"BO_TX_BU_", &Reader::more_senders},
     {"CM_", &Reader::comment},
     {"BA_DEF_", &Reader::attribute_definition},
     {"BA_DEF_DEF_", &Reader::attribute_default},
     {"BA_", &Reader::attribute},
     {"VAL_", &Reader::labels},
     {"SIG_VALTYPE_", &Reader::value_type},
     {"SG_MUL_VAL_", &Reader::multiplexed_values}}};

}  // namespace

Reading read(std::string_view bytes) {
  Reading reading;
  if (bytes.size() > longest_text) {
    reading.errors.push_back({{}, "the file is longer than 16 MiB"});
    return reading;
  }
  const std::string text = to_utf8(bytes);
  Reader(text, reading).read();
  return reading;
}

}  // namespace drydock::wire::dbc
