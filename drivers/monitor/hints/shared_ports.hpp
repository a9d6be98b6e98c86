#pragma once

#include <map>
#include <string>

#include "drivers/measurement/stamp.hpp"

namespace drydock::monitor {

/// Looks from time to time whether another program has the port of a link open too. Each byte of a
/// pty or a serial port goes to only one of them.
class SharedPorts {
 public:
  std::string others(const std::string& link);  ///< in words; empty: none that we may see

 private:
  struct Look {
    measurement::Stamp at{};
    std::string found;
  };
  std::map<std::string, Look> looks_;
};

}  // namespace drydock::monitor
