#include <chrono>

#include "drivers/link/link.hpp"

namespace drydock::link {

Stamp now() {
  using namespace std::chrono;
  return Stamp{duration_cast<nanoseconds>(system_clock::now().time_since_epoch())};
}

}  // namespace drydock::link
