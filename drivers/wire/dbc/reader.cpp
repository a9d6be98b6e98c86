#include "drivers/wire/dbc/reader.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "drivers/wire/dbc/annotations.hpp"
#include "drivers/wire/dbc/keywords.hpp"
#include "drivers/wire/dbc/layout_check.hpp"
#include "drivers/wire/dbc/same_frame.hpp"
#include "drivers/wire/dbc/signal_line.hpp"
#include "drivers/wire/dbc/text_encoding.hpp"

namespace drydock::wire::dbc {

namespace {

constexpr std::uint32_t extended_flag = 0x8000'0000, longest_id = 0x1FFF'FFFF;
constexpr std::uint32_t longest_standard_id = 0x7FF;
constexpr std::string_view orphans = "VECTOR__INDEPENDENT_SIG_MSG";  ///< signals of no message

/// Reads one text.
class Reader {
 public:
  Reader(std::string_view text, Reading& reading)
      : in_(text), contents_{reading.database, Remarks(reading)} {}

  void read() {
    while (!in_.at_end()) next_statement();
    annotations_.all_messages_are_read();
    for (const Scanner& early : early_) {
      in_ = early;
      next_statement();
    }
    finish();
    contents_.remarks.in_order_of_lines();
  }

 private:
  struct Statement {
    std::string_view word;
    void (Reader::*read)();
  };
  static const std::array<Statement, 13> statements;

  static const Statement* statement_of(std::string_view word) {
    const auto* const found = std::ranges::find(statements, word, &Statement::word);
    return found != statements.end() ? found : nullptr;
  }
  void next_statement() {
    try {
      statement_now_or_later();
    } catch (const Unreadable& fault) {
      contents_.remarks.error(fault.remark.at, fault.remark.text);
      skip_to_statement();
    }
  }

  void statement_now_or_later() {
    const Scanner begin = in_;
    try {
      statement();
    } catch (const TooEarly&) {
      in_.skip_to_statement_end();
      in_.accept(';');
      early_.push_back(begin);
    }
  }

  void statement() {
    if (in_.accept(';')) return;
    const std::string_view word = in_.next_word();
    const Statement* known = statement_of(word);
    if (!known && !is_skipped(word))
      in_.fail(word == "SG_" ? "SG_ stands behind no BO_" : "no statement begins so");
    in_.word("a statement");
    if (known) return (this->*known->read)();
    in_.skip_to_statement_end();
    annotations_.end_statement();
  }

  void skip_to_statement() {
    do {
      in_.skip_line();
    } while (!in_.at_end() && (in_.next_word() == "SG_" || !is_keyword(in_.next_word())));
  }

  void version() { in_.string("the version"); }

  /// Keywords without content: indented, or each alone on its line.
  void new_symbols() {
    in_.accept(':');
    while (!in_.at_end() && (!in_.at_margin() || in_.next_word_is_alone())) in_.skip_line();
  }

  void bit_timing() {
    in_.accept(':');
    while (!in_.at_end() && !is_keyword(in_.next_word())) in_.skip_line();
  }

  void nodes() {
    in_.expect(':');
    while (next_is_name(in_)) {
      const std::string name{in_.word("a node")};
      contents_.database.nodes.push_back({name, name, {}});
    }
  }

  void message() {
    Message m;
    m.at = in_.place();
    const std::uint32_t id = read_identifier(in_);
    m.name = m.long_name = in_.word("the message's name");
    in_.expect(':');
    m.size = static_cast<unsigned>(in_.bounded("the number of bytes", 0, most_bytes));
    if (next_is_name(in_)) add_sender(m, in_.word("the sender"));
    std::vector<Choice> choices;
    while (in_.next_word() == "SG_") signal_line(m, choices);
    if (m.name != orphans) add_message(id, std::move(m), std::move(choices));
  }

  void add_message(std::uint32_t id, Message&& m, std::vector<Choice>&& choices) {
    m.id = id & ~extended_flag;
    m.extended = (id & extended_flag) != 0 || m.id > longest_standard_id;
    if (m.id > longest_id)
      return contents_.remarks.error(m.at, "the identifier has more than 29 bits");
    if (m.extended && (id & extended_flag) == 0)
      contents_.remarks.warn(m.at,
                             "an identifier above 7FFh without bit 31: taken for one of 29 bits");
    if (!contents_.places.try_emplace(id, contents_.database.messages.size()).second)
      contents_.remarks.warn(m.at, "a second message has this identifier; the first one holds");
    contents_.database.messages.push_back(std::move(m));
    contents_.choices.push_back(std::move(choices));
  }

  void signal_line(Message& m, std::vector<Choice>& choices) {
    in_.word("SG_");
    try {
      Choice choice;
      Signal signal = read_signal(in_, choice);
      if (m.signals.size() == most_signals) in_.fail("more than 1024 signals in one message");
      if (m.find(signal.name)) contents_.remarks.warn(signal.at, "a second signal has this name");
      m.signals.push_back(std::move(signal));
      choices.push_back(std::move(choice));
    } catch (const Unreadable& fault) {
      contents_.remarks.error(fault.remark.at, fault.remark.text);
      do {
        in_.skip_line();
      } while (!in_.at_end() && !is_keyword(in_.next_word()));
    }
  }

  void more_senders() { annotations_.more_senders(); }
  void comment() { annotations_.comment(); }
  void attribute() { annotations_.attribute(); }
  void labels() { annotations_.labels(); }
  void value_type() { annotations_.value_type(); }
  void multiplexed_values() { annotations_.multiplexed_values(); }

  void attribute_definition() {
    contents_.attributes.define(in_);
    annotations_.end_statement();
  }
  void attribute_default() {
    contents_.attributes.set_default(in_);
    annotations_.end_statement();
  }

  void finish() {
    for (std::size_t i = 0; i < contents_.database.messages.size(); ++i) {
      Message& m = contents_.database.messages[i];
      const double format = contents_.attributes.of(i, Attributes::frame_format).value_or(0);
      if (format == 3 && m.extended) m.format = FrameFormat::j1939;
      if (format == 14 || format == 15) m.format = FrameFormat::fd;
      const double cycle = contents_.attributes.of(i, Attributes::cycle_time).value_or(0);
      if (cycle > 0 && cycle < 1e9) m.cycle_ms = static_cast<unsigned>(cycle);
      resolve_multiplexing(m, contents_.choices[i], contents_.remarks);
      check_layout(m, contents_.remarks);
    }
    warn_of_same_frames();
  }

  /// Of one identifier add_message() has warned.
  void warn_of_same_frames() {
    const auto& messages = contents_.database.messages;
    for (const auto& [first, second] : same_frames(messages))
      if (messages[first].id != messages[second].id)
        contents_.remarks.warn(
            messages[second].at,
            "message " + messages[second].name + " has the same frames as " + messages[first].name +
                " of line " + std::to_string(messages[first].at.line) + ": none tells them apart");
  }

  Scanner in_;
  Contents contents_;
  Annotations annotations_{in_, contents_};
  std::vector<Scanner> early_;  ///< at statements on messages that stand behind them
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
  if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) {
    reading.errors.push_back({{}, "the file is UTF-16: convert it to UTF-8"});
    return reading;
  }
  const std::string text = to_utf8(bytes);
  Reader(text, reading).read();
  return reading;
}

}  // namespace drydock::wire::dbc
