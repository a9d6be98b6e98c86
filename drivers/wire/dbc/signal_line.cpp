#include "drivers/wire/dbc/signal_line.hpp"

#include "drivers/wire/dbc/keywords.hpp"

namespace drydock::wire::dbc {

namespace {

/// The N of mN. Empty if it is none.
std::optional<std::int64_t> selecting_value(std::string_view word) {
  if (word.front() != 'm') return std::nullopt;
  try {
    Scanner in(word.substr(1));
    const std::int64_t value = in.integer("the selecting value");
    return in.at_end() ? std::optional(value) : std::nullopt;
  } catch (const Unreadable&) {
    return std::nullopt;
  }
}

/// M, mN or mNM.
void read_multiplexor(Scanner& in, Signal& s, Choice& choice) {
  const Place at = in.place();
  std::string_view word = in.word("':'");
  s.selector = word.ends_with('M');
  if (s.selector) word.remove_suffix(1);
  if (word.empty()) return;
  choice.value = selecting_value(word);
  if (!choice.value) throw Unreadable{{at, "neither ':' nor a multiplexor as M, m0, m0M"}};
}

Layout read_layout(Scanner& in) {
  Layout l;
  const Place at = in.place();
  l.start = static_cast<unsigned>(in.bounded("the start bit", 0, 8 * most_bytes - 1));
  in.expect('|');
  l.bits = static_cast<unsigned>(in.bounded("the number of bits", 1, 64));
  in.expect('@');
  l.order = in.one_of("01") == '1' ? ByteOrder::intel : ByteOrder::motorola;
  l.number = in.one_of("+-") == '-' ? Number::signed_integer : Number::unsigned_integer;
  if (l.bytes_needed() > most_bytes) throw Unreadable{{at, "the signal ends behind byte 4095"}};
  in.expect('(');
  l.factor = in.number("the factor");
  in.expect(',');
  l.offset = in.number("the offset");
  in.expect(')');
  return l;
}

void read_limits(Scanner& in, Signal& s) {
  in.expect('[');
  s.lowest = in.told_number("the lowest value");
  in.expect('|');
  s.highest = in.told_number("the highest value");
  in.expect(']');
}

void skip_receivers(Scanner& in) {
  while (next_is_name(in)) {
    in.word("a receiver");
    in.accept(',');
  }
}

}  // namespace

Signal read_signal(Scanner& in, Choice& choice) {
  Signal s;
  s.at = in.place();
  s.name = s.long_name = in.word("the signal's name");
  if (!in.next_is(':')) read_multiplexor(in, s, choice);
  in.expect(':');
  s.layout = read_layout(in);
  read_limits(in, s);
  s.unit = in.string("the unit");
  skip_receivers(in);
  return s;
}

}  // namespace drydock::wire::dbc
