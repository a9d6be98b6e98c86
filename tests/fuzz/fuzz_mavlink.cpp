#include <vector>

#include "drivers/wire/mavlink/mavlink.hpp"
#include "tests/fuzz/fuzz_protocol.hpp"

/// Every frame that is read is written again and then read as the same message: the bytes of a
/// second writing are those of the first, also where a number is a NaN.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace drydock::wire;
  using fuzz::require;
  const auto written = [](const Mavlink::Message& message) {
    std::vector<std::uint8_t> frame(Mavlink::max_frame);
    frame.resize(mavlink::encode(message, frame));
    return frame;
  };
  Framer<Mavlink::max_frame> framer;
  framer.feed({data, size}, Mavlink::scan, [&](Bytes frame, std::size_t) {
    const auto message = Mavlink::decode(frame);
    if (!message) return;
    const auto once = written(*message);
    require(Mavlink::scan(once) == Scan::frame(once.size()));
    require(written(*Mavlink::decode(once)) == once);
  });
  const StreamCounters& c = framer.counters();
  require(c.bytes_in == c.bytes_good + c.bytes_skipped + framer.held());
  Mavlink::decode({data, size});
  return 0;
}
