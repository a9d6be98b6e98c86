#include "drivers/wire/nmea2000/nmea2000.hpp"
#include "tests/fuzz/fuzz_frames.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::wire::fuzz::feed_frames<drydock::wire::Nmea2000>({data, size});
  return 0;
}
