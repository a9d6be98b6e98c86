#include "drivers/wire/dvl/wayfinder.hpp"
#include "tests/fuzz/fuzz_protocol.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::wire::fuzz::feed<drydock::wire::Wayfinder>({data, size});
  return 0;
}
