#include <memory>
#include <sstream>

#include "drivers/recordings/mcap/reader.hpp"

/// Any bytes: the reader ends, says why, and every message it gave lies inside what it was given.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace drydock::mcap;
  Reader reader(
      std::make_unique<std::istringstream>(std::string(reinterpret_cast<const char*>(data), size)));
  volatile std::uint64_t sum = 0;  // reads every byte
  bool complete = false;
  while (const auto record = reader.next()) {
    complete = std::holds_alternative<DataEnd>(*record);
    if (const auto* message = std::get_if<Message>(&*record))
      for (const auto byte : message->data) sum = sum + byte;
  }
  // A file may be whole up to the end of its data and cut in its summary.
  if (reader.position() > size || (!complete && reader.damage().empty())) __builtin_trap();
  return 0;
}
