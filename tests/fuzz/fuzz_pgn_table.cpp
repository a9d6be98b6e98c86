#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "drivers/decode/pgn_table_file.hpp"
#include "drivers/wire/pgn_table/decode.hpp"

/// The last 223 bytes are a message, all before is the text of a table.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace drydock;
  const wire::Bytes input{data, size};
  const std::size_t message_size = std::min<std::size_t>(size, 223);
  const wire::Bytes text = input.first(size - message_size);
  const auto table =
      decode::read_pgn_table({reinterpret_cast<const char*>(text.data()), text.size()});
  if (!table) {
    if (table.error().text.empty()) std::abort();
    return 0;
  }
  const wire::pgn_table::Catalogue catalogue(*table);
  for (const auto& definition : table->definitions)
    wire::pgn_table::decode(catalogue, definition, input.last(message_size));
  return 0;
}
