#include "drivers/wire/dbc/writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

namespace drydock::wire::dbc {
namespace {

constexpr std::string_view no_node = "Vector__XXX";

std::uint32_t identifier_of(const Message& m) { return m.id | (m.extended ? 0x8000'0000u : 0u); }

std::string in_quotes(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '\\';
    out += c;
  }
  return out + '"';
}

/// True if `mN` does not say it all: several selectors, or ranges.
bool needs_ranges(const Message& m) {
  const auto selectors = std::ranges::count_if(m.signals, &Signal::selector);
  return selectors > 1 || std::ranges::any_of(m.signals, [](const Signal& s) {
           return s.when.size() > 1 || (s.when.size() == 1 && s.when[0].first != s.when[0].last);
         });
}

std::string multiplexor_of(const Signal& s) {
  std::string text;
  if (s.selected_by) text += fmt::format("m{}", s.when.empty() ? 0 : s.when.front().first);
  if (s.selector) text += 'M';
  return text.empty() ? text : text + ' ';
}

std::string signal_line(const Signal& s) {
  const Layout& l = s.layout;
  return fmt::format(" SG_ {} {}: {}|{}@{}{} ({},{}) [{}|{}] {} {}\n", s.name, multiplexor_of(s),
                     l.start, l.bits, l.order == ByteOrder::intel ? 1 : 0,
                     l.number == Number::unsigned_integer ? '+' : '-', l.factor, l.offset, s.lowest,
                     s.highest, in_quotes(s.unit), no_node);
}

std::string message_text(const Message& m) {
  std::string text = fmt::format("\nBO_ {} {}: {} {}\n", identifier_of(m), m.name, m.size,
                                 m.senders.empty() ? no_node : m.senders.front());
  for (const Signal& s : m.signals) text += signal_line(s);
  return text;
}

/// As VFrameFormat numbers them; 0 is its default, for frames that are neither.
int frame_format(const Message& m) {
  if (m.format == FrameFormat::j1939) return 3;
  return m.format == FrameFormat::fd ? 14 + (m.extended ? 1 : 0) : 0;
}

std::string message_notes(const Message& m) {
  const auto id = identifier_of(m);
  std::string text;
  if (m.senders.size() > 1)
    text += fmt::format("BO_TX_BU_ {} : {};\n", id, fmt::join(m.senders, ","));
  if (!m.comment.empty()) text += fmt::format("CM_ BO_ {} {};\n", id, in_quotes(m.comment));
  if (m.cycle_ms != 0) text += fmt::format("BA_ \"GenMsgCycleTime\" BO_ {} {};\n", id, m.cycle_ms);
  if (const int format = frame_format(m); format != 0)
    text += fmt::format("BA_ \"VFrameFormat\" BO_ {} {};\n", id, format);
  if (m.long_name != m.name)
    text += fmt::format("BA_ \"SystemMessageLongSymbol\" BO_ {} {};\n", id, in_quotes(m.long_name));
  return text;
}

std::string raw_value(const Signal& s, std::int64_t raw) {
  const bool is_unsigned = s.layout.number == Number::unsigned_integer && s.layout.bits == 64;
  return is_unsigned ? std::to_string(static_cast<std::uint64_t>(raw)) : std::to_string(raw);
}

std::string signal_notes(const Message& m, const Signal& s) {
  const std::string of = fmt::format("{} {}", identifier_of(m), s.name);
  std::string text;
  if (!s.comment.empty()) text += fmt::format("CM_ SG_ {} {};\n", of, in_quotes(s.comment));
  if (s.long_name != s.name)
    text += fmt::format("BA_ \"SystemSignalLongSymbol\" SG_ {} {};\n", of, in_quotes(s.long_name));
  if (s.layout.is_float()) text += fmt::format("SIG_VALTYPE_ {} : {};\n", of, s.layout.bits / 32);
  if (!s.labels.empty()) {
    text += fmt::format("VAL_ {}", of);
    for (const Label& label : s.labels)
      text += " " + raw_value(s, label.raw) + " " + in_quotes(label.text);
    text += " ;\n";
  }
  if (s.selected_by && !s.when.empty() && needs_ranges(m)) {
    text += fmt::format("SG_MUL_VAL_ {} {}", of, m.signals[*s.selected_by].name);
    for (std::size_t i = 0; i < s.when.size(); ++i)
      text += fmt::format("{} {}-{}", i > 0 ? "," : "", s.when[i].first, s.when[i].last);
    text += ";\n";
  }
  return text;
}

}  // namespace

std::string write(std::span<const Message> messages) {
  std::set<std::string> nodes;
  std::string texts, notes;
  for (const Message& m : messages) {
    nodes.insert(m.senders.begin(), m.senders.end());
    texts += message_text(m);
    notes += message_notes(m);
    for (const Signal& s : m.signals) notes += signal_notes(m, s);
  }
  return fmt::format(
      "VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_:{}{}\n{}\n"
      "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 3600000;\n"
      "BA_DEF_ BO_ \"VFrameFormat\" INT 0 15;\n"
      "BA_DEF_ BO_ \"SystemMessageLongSymbol\" STRING;\n"
      "BA_DEF_ SG_ \"SystemSignalLongSymbol\" STRING;\n"
      "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\nBA_DEF_DEF_ \"VFrameFormat\" 0;\n"
      "BA_DEF_DEF_ \"SystemMessageLongSymbol\" \"\";\n"
      "BA_DEF_DEF_ \"SystemSignalLongSymbol\" \"\";\n{}",
      nodes.empty() ? "" : " ", fmt::join(nodes, " "), texts, notes);
}

}  // namespace drydock::wire::dbc
