#include "drivers/wire/j1939/mv5.hpp"
#include "tests/fuzz/fuzz_frames.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::wire::fuzz::feed_frames<drydock::wire::Mv5>({data, size});
  return 0;
}
