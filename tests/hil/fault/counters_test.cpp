// Bytes in = bytes in good frames + skipped + held, for any faults: every byte protocol under
// random faults, several at once.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "hil/fault/schedule/random_faults.hpp"
#include "tests/hil/fault/line_bench.hpp"

namespace drydock::fault::test {
namespace counters_test {

struct Line {
  const char *kind, *protocol;
};

constexpr Line lines[] = {{"dvl", "pd0"},          {"dvl", "pd4"},
                          {"dvl", "pd5"},          {"dvl", "pd6"},
                          {"dvl", "nortek"},       {"dvl", "nortek-ad2cp"},
                          {"dvl", "water-linked"}, {"dvl", "water-linked-json"},
                          {"dvl", "wayfinder"},    {"emlog", "nmea0183"},
                          {"gnss", "ubx"},         {"gnss", "nmea0183"}};

std::string table_of(const Line& line) {
  return std::string("[[device]]\nname = \"dvl\"\nkind = \"") + line.kind + "\"\nprotocol = \"" +
         line.protocol + "\"\nlink = \"pty:line?baud=115200\"\nrate_hz = 5\n";
}

RC_GTEST_PROP(FaultCounters, EveryByteOfALineIsAccountedForUnderAnyFaults, ()) {
  const Line& line = *rc::gen::elementOf(std::vector<Line>(std::begin(lines), std::end(lines)));
  LineBench bench(table_of(line));
  RandomFaults random(bench.rig(), *rc::gen::arbitrary<std::uint64_t>(), 4);
  auto next = random.next();
  for (int second = 1; second <= 60; ++second) {
    for (; next.start_s < second; next = random.next()) {
      auto from_now = next;
      from_now.start_s = 0;
      if (!bench.set(from_now)) RC_FAIL("a fault that the device can have was refused");
    }
    bench.run_to(second);
    const auto health = bench.health();
    const auto& stream = health.stream;
    RC_ASSERT(stream.bytes_in == stream.bytes_good + stream.bytes_skipped + health.held_bytes);
    RC_ASSERT(stream.bytes_in <= bench.bytes_carried());  // fewer bytes while the port is not open
  }
}

}  // namespace counters_test
}  // namespace drydock::fault::test
