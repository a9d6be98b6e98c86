#pragma once

#include <boost/container/static_vector.hpp>
#include <vector>

#include "estimators/consistency/devices.hpp"
#include "estimators/consistency/doubts.hpp"
#include "estimators/consistency/test.hpp"

namespace drydock::consistency {

/// One test and the devices that would make it fire. Of the fired tests of a device the one whose
/// shape is clearest gives the word.
struct Accusation {
  Devices devices;
  const Test* test = nullptr;
  const Freeze* freeze = nullptr;
  bool secondary = false;  ///< it follows from what another quantity of the device does
};
using Accusations = boost::container::static_vector<Accusation, 160>;

/// A device that the tests name.
struct Named {
  std::uint16_t device = 0;
  const Accusation* by = nullptr;
  bool alone = true;  ///< false: another device could explain the same tests
};

/// The parity signature: which devices explain all fired tests. A test that names one device names
/// it at once. The rest is explained by the device that stands in most of them and in fewest quiet
/// ones, after `patience`.
class Parity {
 public:
  using Names = boost::container::static_vector<Named, 16>;
  static constexpr std::chrono::milliseconds patience{2000};

  /// The names point into `accusations`. Of several devices, one that is guilty by other
  /// evidence (`doubts`) explains a test.
  Names name(const Accusations& accusations, const Doubts& doubts, Stamp now);

 private:
  struct Held {
    const Test* test;
    std::uint16_t device;
  };
  Named held(const Accusation& fired, Named named);

  boost::container::static_vector<Held, 64> held_;
};

}  // namespace drydock::consistency
