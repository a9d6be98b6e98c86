#pragma once

#include <array>
#include <cstdint>

#include "drivers/diagnosis/monitors/event_test.hpp"
#include "drivers/diagnosis/monitors/teller.hpp"

namespace drydock::diagnosis {

/// What happened to the messages of one device, one after the other, and the test of each event. A
/// fault makes several: which one it is, their numbers among the last 64 messages tell.
class ArrivalEvents {
 public:
  /// A sound line loses, repeats or delays less than one message in 10'000. One in 20 is a fault.
  static constexpr double usual = 1e-4, raised = 0.05;

  void nothing(Stamp at);
  void gap(Stamp since) { happened(Happened::gap, gaps_, since); }
  void repeat(Stamp at) { happened(Happened::repeat, repeats_, at); }
  void swap(Stamp at) { happened(Happened::swap, swaps_, at); }
  void odd(Stamp at) { happened(Happened::odd, odds_, at); }
  void backwards(Stamp at) { backwards_.add(true, at); }
  /// Messages were lost from the start on.
  void lost_from_the_start(Stamp first);

  /// What the raster of a stream shows, at a message that was off it.
  void tell(const Teller& teller, Stamp at) const;
  /// Messages in an order that never was.
  void tell_order(const Teller& teller, Stamp at) const;
  void tell_backwards(const Teller& teller, Stamp at) const;

 private:
  enum class Happened : std::uint8_t { odd, repeat, swap, gap, nothing };
  /// exp(18) messages to a false alarm; three events close together fire.
  static constexpr double threshold = 18;

  void happened(Happened what, EventTest& test, Stamp at);
  void note(Happened what);
  int lately(Happened what) const;  ///< of the last 64 messages
  static void tell_if_fired(const Teller& teller, Sign sign, const EventTest& test,
                            std::string_view what, Stamp at);

  EventTest gaps_{usual, raised, threshold}, repeats_{usual, raised, threshold},
      swaps_{usual, raised, threshold}, odds_{usual, raised, threshold},
      backwards_{usual, raised, threshold};
  std::array<std::uint64_t, 4> history_{};  ///< one bit a message for each Happened
};

}  // namespace drydock::diagnosis
