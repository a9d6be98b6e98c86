// A table of PGNs in front of any bytes: nothing breaks, and no message makes more output than it
// has bits.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "drivers/decode/pgn_table_file.hpp"
#include "drivers/wire/pgn_table/bits.hpp"
#include "drivers/wire/pgn_table/decode.hpp"
#include "tests/drivers/decode/captured.hpp"

namespace drydock::decode {
namespace pgn_table_test {

namespace pgn_table = wire::pgn_table;
using Octets = std::vector<std::uint8_t>;

const std::string& text_of_table() {
  static const std::string text = read_file(DRYDOCK_SOURCE_DIR "/fixtures/pgns/table.json");
  return text;
}

const pgn_table::Table& table() {
  static const auto read = read_pgn_table(text_of_table());
  return *read;
}

std::size_t values_of(const pgn_table::Record& record) {
  std::size_t count = record.values.size();
  for (const auto& set : record.sets)
    for (const auto& one : set) count += values_of(one);
  return count;
}

RC_GTEST_PROP(PgnTable, AnyBytesGiveAtMostAValueForEachFieldAndEachBit, ()) {
  const pgn_table::Catalogue catalogue(table());
  const auto bytes = *rc::gen::container<Octets>(rc::gen::arbitrary<std::uint8_t>());
  for (const auto& definition : table().definitions) {
    const auto message = decode(catalogue, definition, bytes);
    RC_ASSERT(values_of(message.record) <= definition.fields.size() + 8 * bytes.size());
  }
}

RC_GTEST_PROP(PgnTable, ADamagedTableIsReadOrRefusedWithAReason, ()) {
  std::string text = text_of_table();
  for (int damage = *rc::gen::inRange(1, 4); damage > 0; --damage)
    text[*rc::gen::inRange<std::size_t>(0, text.size())] =
        *rc::gen::elementOf(std::string("0123456789\"[]{},:abcSTRING_-. "));
  const auto read = read_pgn_table(text);
  if (!read) {
    RC_ASSERT(!read.error().text.empty());
    return;
  }
  const pgn_table::Catalogue catalogue(*read);
  const Octets bytes(60, *rc::gen::arbitrary<std::uint8_t>());
  for (const auto& definition : read->definitions) decode(catalogue, definition, bytes);
}

/// By the closed form: the number of all bits, shifted and cut.
RC_GTEST_PROP(PgnTable, BitsAreThoseOfTheLittleEndianNumber, (std::uint64_t number)) {
  Octets bytes;
  for (int i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
  const auto offset = *rc::gen::inRange<std::size_t>(0, 64);
  const auto count = *rc::gen::inRange<std::size_t>(1, 65);
  const auto bits = pgn_table::bits_at(bytes, offset, count);
  RC_ASSERT(bits.has_value() == (offset + count <= 64));
  if (!bits) return;
  const std::uint64_t mask = count == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
  RC_ASSERT(*bits == (number >> offset & mask));
}

}  // namespace pgn_table_test
}  // namespace drydock::decode
