#include <gtest/gtest.h>

#include "drivers/wire/protocols.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

TEST(EmulatedDevices, EveryProtocolIsEmulatedForEachOfItsKindsAndNoOther) {
  const Frozen trajectory(at_the_surface());
  for (const wire::Protocol& protocol : wire::protocols()) {
    for (const auto kind : measurement::kinds) {
      const auto made =
          make_emulated_device(device(kind, std::string(protocol.name)), trajectory, 1);
      EXPECT_EQ(made.has_value(), protocol.kinds.has(kind) && protocol.emulated)
          << to_string(kind) << " " << protocol.name;
    }
  }
}

}  // namespace
}  // namespace drydock::emulate
