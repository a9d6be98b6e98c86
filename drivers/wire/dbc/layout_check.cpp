#include "drivers/wire/dbc/layout_check.hpp"

#include <bitset>

#include "drivers/wire/dbc/bits.hpp"
#include "drivers/wire/dbc/multiplexing.hpp"

namespace drydock::wire::dbc {

namespace {

/// The bytes that a signal touches, with its bits of each.
struct Footprint {
  unsigned first = 0, count = 0;  ///< bytes
  std::array<std::uint8_t, 9> bits{};

  explicit Footprint(const Layout& layout) : first(layout.start / 8) {
    std::array<std::uint8_t, 9> shifted{};
    Layout moved = layout;
    moved.start = layout.start % 8;
    store_bits(shifted, moved, ~std::uint64_t{0});
    bits = shifted;
    count = moved.bytes_needed();
  }

  bool meets(const Footprint& other) const {
    for (unsigned i = 0; i < count; ++i) {
      const unsigned byte = first + i;
      if (byte < other.first || byte >= other.first + other.count) continue;
      if ((bits[i] & other.bits[byte - other.first]) != 0) return true;
    }
    return false;
  }
};

void check_end(const Message& message, const Signal& signal, Remarks& remarks) {
  if (signal.layout.bytes_needed() <= message.size) return;
  remarks.warn(signal.at, "signal " + signal.name + " ends beyond the " +
                              std::to_string(message.size) + " bytes of " + message.name);
}

void check_factor(const Signal& signal, Remarks& remarks) {
  if (signal.layout.factor == 0)
    remarks.warn(signal.at, "signal " + signal.name + " has the factor 0: it always is its offset");
}

}  // namespace

void check_layout(const Message& message, Remarks& remarks) {
  std::vector<Footprint> prints;
  for (const Signal& b : message.signals) {
    check_end(message, b, remarks);
    check_factor(b, remarks);
    const Footprint print(b.layout);
    for (std::size_t i = 0; i < prints.size(); ++i) {
      const Signal& a = message.signals[i];
      if (!print.meets(prints[i]) || !may_stand_together(message, a, b)) continue;
      remarks.warn(b.at, "signal " + b.name + " shares bits with " + a.name);
      break;  // one is enough to look at the signal
    }
    prints.push_back(print);
  }
}

}  // namespace drydock::wire::dbc
