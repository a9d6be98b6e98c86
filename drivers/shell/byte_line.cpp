#include "drivers/shell/byte_line.hpp"

#include <utility>
#include <vector>

#include "drivers/link/file.hpp"
#include "drivers/shell/recording_clock.hpp"

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

/// A recording at a pace is read in the time of the clock that one of its devices tells, if any.
ByteLine::Opened ByteLine::open(const link::Uri& uri) {
  const bool paced = uri.recorded() && uri.speed().value_or(0) > 0;
  if (!paced || devices().empty()) return LinkedLine::open(uri);
  std::vector<device::DriverOptions> drivers;
  for (const device::Device* device : devices()) drivers.push_back(device->options().driver);
  auto clock = clock_of(uri, drivers, device::Travels::as_bytes);
  return link::open_file(executor(), uri, link::Side::driver, std::move(clock.times.messages));
}

void ByteLine::observe_link() {
  for (device::Device* device : devices()) device->note_link(current_link().note());
}

void ByteLine::receive(const wire::Bytes& bytes, Stamp at) {
  for (device::Device* device : devices()) device->receive(bytes, at);
}

}  // namespace drydock::shell
