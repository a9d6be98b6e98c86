#include "drivers/wire/can/sbg.hpp"
#include "tests/fuzz/fuzz_frames.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::wire::fuzz::feed_frames<drydock::wire::Sbg>({data, size});
  return 0;
}
