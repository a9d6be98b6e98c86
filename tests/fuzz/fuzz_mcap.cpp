#include <memory>
#include <sstream>

#include "drivers/recordings/mcap/reader.hpp"

/// For any bytes the reader ends and says why. Every message that it gave lies inside the input.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace drydock::mcap;
  Reader reader(
      std::make_unique<std::istringstream>(std::string(reinterpret_cast<const char*>(data), size)));
  volatile std::uint64_t sum = 0;  // makes the loop read every byte
  bool complete = false;
  while (const auto record = reader.next()) {
    complete = std::holds_alternative<DataEnd>(*record);
    if (const auto* message = std::get_if<Message>(&*record))
      for (const auto byte : message->data) sum = sum + byte;
  }
  // A file may be complete to the end of its data but truncated in its summary.
  if (reader.position() > size || (!complete && reader.damage().empty())) __builtin_trap();
  return 0;
}
