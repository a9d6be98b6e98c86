#include <array>
#include <cstdlib>

#include "drivers/wire/can/gateway_line.hpp"

using namespace drydock::wire;

/// What is read as an order is written as an order of the same frame.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto frame = gateway_line::parse_order({reinterpret_cast<const char*>(data), size});
  if (!frame) return 0;
  std::array<std::uint8_t, gateway_line::longest> line;
  const std::size_t written = gateway_line::encode_order(*frame, line);
  const std::string_view order(reinterpret_cast<const char*>(line.data()), written);
  if (!order.ends_with("\r\n") || gateway_line::parse_order(order.substr(0, written - 2)) != frame)
    std::abort();
  return 0;
}
