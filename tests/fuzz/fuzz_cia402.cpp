#include <algorithm>
#include <cstdlib>

#include "drivers/wire/canopen/cia402.hpp"

using namespace drydock::wire;

/// Every 11 bytes are a frame: identifier, length, data. A drive that follows the orders among them
/// is never in operation straight after a fault.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t step = 11;
  Cia402::Decoder decoder;
  cia402::DriveState state = cia402::DriveState::fault;
  std::uint16_t word = 0;
  for (; size >= step; data += step, size -= step) {
    CanFrame frame;
    frame.id = (data[0] | data[1] << 8) & 0x7FF;
    frame.size = data[2] % 9;
    std::copy_n(data + 3, frame.size, frame.data.begin());
    const auto message = decoder.receive(frame);
    if (!message) continue;
    if (const auto* order = std::get_if<cia402::DriveOrder>(&*message)) {
      const auto before = state;
      state = cia402::after(state, order->control_word, word);
      word = order->control_word;
      if (before == cia402::DriveState::fault && state == cia402::DriveState::operation_enabled)
        std::abort();
      const auto told = cia402::state_of(cia402::status_word_of(state));
      if (told != state) std::abort();
    }
  }
  const StreamCounters& c = decoder.counters();
  if (c.bytes_in != c.bytes_good + c.bytes_skipped) std::abort();
  return 0;
}
