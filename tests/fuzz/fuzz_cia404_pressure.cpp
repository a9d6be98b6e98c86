#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "drivers/wire/canopen/cia404_pressure.hpp"

using namespace drydock::wire;

/// Every 11 bytes are a frame: identifier, length, data.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t step = 11;
  Cia404Pressure::Decoder decoder;
  for (; size >= step; data += step, size -= step) {
    CanFrame frame;
    frame.id = (data[0] | data[1] << 8) & 0x7FF;
    frame.size = data[2] % 9;
    std::copy_n(data + 3, frame.size, frame.data.begin());
    const auto message = decoder.receive(frame);
    if (!message) continue;
    const auto* value = std::get_if<cia404_pressure::ProcessValue>(&*message);
    if (!value) continue;
    for (const auto form : {cia404_pressure::Form::integer, cia404_pressure::Form::real32}) {
      const auto pressure =
          cia404_pressure::pressure_pa(*value, {form, cia404_pressure::units[0], 3});
      if (pressure && !std::isfinite(*pressure)) std::abort();
    }
  }
  const StreamCounters& c = decoder.counters();
  if (c.bytes_in != c.bytes_good + c.bytes_skipped) std::abort();
  return 0;
}
