#include "tests/drivers/described/support.hpp"

/// Checksums by their names, against the catalogue of CRCs and sums by hand.
namespace drydock::described::test {
namespace checksums_test {

using wire::testing::as_bytes;
using wire::testing::Buffer;

TEST(DescribedValues, ChecksumsOfNineDigitsAreThoseOfTheCatalogue) {
  const Buffer digits = as_bytes("123456789");
  for (const auto& crc : wire::described::crcs) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(crc.name, checksum));
    EXPECT_EQ(checksum.of(digits), crc.check) << crc.name;
  }
  // Sums by hand: the digits are 49 to 57.
  for (const auto& [name, sum] :
       {std::pair("sum-8", 0xDDu), std::pair("sum-16", 0x1DDu), std::pair("sum-32", 0x1DDu),
        std::pair("xor", 0x31u), std::pair("fletcher-16", 0x15DDu),
        std::pair("fletcher-16-255", 0x1EDEu), std::pair("sum-8-inverted", 0x22u),
        std::pair("word-sum-16", 0xD509u), std::pair("word-sum-16-big", 0x09D4u),
        std::pair("sum-16-negative", 0xFE23u), std::pair("sum-32-inverted", 0xFFFFFE22u),
        std::pair("word-sum-16-negative", 0x2AF7u),
        std::pair("word-sum-16-big-inverted", 0xF62Bu)}) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(name, checksum));
    EXPECT_EQ(checksum.of(digits), sum) << name;
  }
}

TEST(DescribedValues, AnotherNameOfTheCatalogueIsTheSameChecksumInCapitalsOrNot) {
  const Buffer digits = as_bytes("123456789");
  for (const auto& [name, check] :
       {std::pair("crc-16/ccitt-false", 0x29B1u), std::pair("CRC-16/X-25", 0x906Eu),
        std::pair("CRC-32", 0xCBF43926u), std::pair("crc-32c", 0xE3069283u),
        std::pair("CRC-8", 0xF4u), std::pair("Modbus", 0x4B37u)}) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(name, checksum)) << name;
    EXPECT_EQ(checksum.of(digits), check) << name;
  }
  for (const auto& alias : wire::described::crc_aliases) {
    wire::described::Checksum checksum;
    ASSERT_TRUE(wire::described::Checksum::find(alias.alias, checksum)) << alias.alias;
    EXPECT_EQ(checksum.name(), alias.name);
  }
}

}  // namespace checksums_test
}  // namespace drydock::described::test
