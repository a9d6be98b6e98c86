#include "drivers/wire/dvl/water_linked_json.hpp"
#include "tests/fuzz/fuzz_protocol.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  drydock::wire::fuzz::feed<drydock::wire::WaterLinkedJson>({data, size});
  return 0;
}
