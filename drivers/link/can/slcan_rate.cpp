#include "drivers/link/can/slcan_rate.hpp"

#include "drivers/wire/can/slcan.hpp"

namespace drydock::link {

SlcanRate::SlcanRate(const SlcanChannel& channel)
    : command_(wire::slcan::bit_rate_command(channel.bit_rate).value()),
      searches_(channel.searches) {}

std::optional<unsigned> SlcanRate::found() const {
  if (!searches_ || !found_) return {};
  return slcan_search_order[tried_];
}

void SlcanRate::choose() {
  if (!searches_) return;
  const unsigned rate = slcan_search_order[tried_];
  command_ = wire::slcan::bit_rate_command(rate).value();
  note_ = found_ ? std::to_string(rate) + " bit/s, found by listening"
                 : "no frame yet: listens at each bit rate for 2 s, now at " +
                       std::to_string(rate) + " bit/s (bitrate=... states it)";
}

void SlcanRate::try_next() {
  tried_ = (tried_ + 1) % slcan_search_order.size();
  choose();
}

void SlcanRate::is_that_of_the_bus() {
  found_ = true;
  choose();
}

}  // namespace drydock::link
