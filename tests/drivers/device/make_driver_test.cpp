#include "drivers/device/make_driver.hpp"

#include <gmock/gmock.h>

namespace drydock::device::make_driver_test {
namespace {

/// "pd0 over bytes", sorted by the matcher.
std::vector<std::string> driven(Kind kind) {
  std::vector<std::string> all;
  for (const auto& entry : protocols_of(kind))
    all.push_back(std::string(entry.name) +
                  (entry.travels == Travels::as_bytes ? " over bytes" : " over frames"));
  return all;
}

std::vector<std::string> in_the_table(Kind kind) {
  std::vector<std::string> all;
  for (const wire::Protocol& protocol : wire::protocols())
    if (protocol.kinds.has(kind))
      all.push_back(std::string(protocol.name) +
                    (protocol.travels == Travels::as_bytes ? " over bytes" : " over frames"));
  return all;
}

TEST(MakeDriver, EveryProtocolHasADriverForEachOfItsKindsAndNoOther) {
  for (const Kind kind : measurement::kinds) {
    EXPECT_FALSE(driven(kind).empty()) << to_string(kind);
    EXPECT_THAT(driven(kind), testing::UnorderedElementsAreArray(in_the_table(kind)))
        << to_string(kind);
  }
}

TEST(MakeDriver, WhoAsksForTheValueOfARefusalGetsItsLineAsAnException) {
  DriverOptions options;
  options.kind = Kind::dvl;
  options.protocol = "pd7";
  EXPECT_THAT([&] { make_byte_driver(options).value(); },
              testing::ThrowsMessage<std::invalid_argument>(
                  testing::HasSubstr("with protocol \"pd7\" over bytes; allowed: ")));
}

}  // namespace
}  // namespace drydock::device::make_driver_test
