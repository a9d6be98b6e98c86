#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "tests/fuzz/fuzz_protocol.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::wire::fuzz::feed<drydock::wire::Nmea0183>({data, size});
  return 0;
}
