#include "drivers/shell/byte_line.hpp"

#include <utility>

namespace drydock::shell {

/// The URI with the rate that the search has reached.
link::Uri ByteLine::next_uri() {
  link::Uri next = uri();
  if (!searches_baud(next)) return next;
  std::uint64_t heard = 0;
  for (const device::Device* device : devices()) heard += device->messages();
  search_.open_again(heard > std::exchange(heard_before_, heard));
  next.query["baud"] = std::to_string(search_.baud());
  for (device::Device* device : devices()) device->set_baud(search_.baud());
  return next;
}

void ByteLine::receive(const wire::Bytes& bytes, Stamp at) {
  for (device::Device* device : devices()) device->receive(bytes, at);
}

}  // namespace drydock::shell
