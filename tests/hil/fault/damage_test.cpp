// Damage to single messages. The characters that a receiver reads at the wrong baud rate are
// computed by hand from the levels of 8N1, least significant bit first.
#include "hil/fault/wire/damage.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <bit>

namespace drydock::fault::test {
namespace damage_test {

using testing::ElementsAre;
using testing::ElementsAreArray;

Message bytes(std::string_view text) { return {text.begin(), text.end()}; }

int bits_that_differ(const Message& a, const Message& b) {
  int bits = 0;
  for (std::size_t i = 0; i < a.size(); ++i) bits += std::popcount(unsigned{a[i]} ^ unsigned{b[i]});
  return bits;
}

TEST(Damage, AFlipTurnsOverExactlyOneBitAnywhere) {
  RandomStream random(1, "dvl", "flip");
  const Message sound(16, 0x5A);
  std::array<int, 128> hits{};
  for (int i = 0; i < 12'800; ++i) {
    Message message = sound;
    flip_bit(message, random);
    ASSERT_EQ(bits_that_differ(message, sound), 1);
    for (std::size_t bit = 0; bit < hits.size(); ++bit)
      hits[bit] += (message[bit / 8] ^ sound[bit / 8]) >> bit % 8 & 1;
  }
  // Expected: 100 at each place, standard deviation 10.
  EXPECT_GT(*std::ranges::min_element(hits), 55);
  EXPECT_LT(*std::ranges::max_element(hits), 145);
}

/// The six bytes of a UBX header: two of sync, class, ID, two of length.
TEST(Damage, AFlippedHeaderHasOneOtherBitInItsFirstSixBytes) {
  RandomStream random(1, "gnss", "flip-header");
  const Message sound(16, 0x5A);
  std::array<int, 48> hits{};
  for (int i = 0; i < 4800; ++i) {
    Message message = sound;
    flip_header_bit(message, random);
    ASSERT_EQ(bits_that_differ(message, sound), 1);
    ASSERT_TRUE(std::equal(message.begin() + 6, message.end(), sound.begin() + 6));
    for (std::size_t bit = 0; bit < hits.size(); ++bit)
      hits[bit] += (message[bit / 8] ^ sound[bit / 8]) >> bit % 8 & 1;
  }
  // Expected: 100 at each place, standard deviation 10.
  EXPECT_GT(*std::ranges::min_element(hits), 55);
  EXPECT_LT(*std::ranges::max_element(hits), 145);
}

TEST(Damage, ATruncatedMessageIsAProperBeginningOfIt) {
  RandomStream random(1, "dvl", "truncate");
  for (int i = 0; i < 1000; ++i) {
    Message message = bytes("$GPZDA,201530.00,04,07,2002,00,00*60\r\n");
    const Message sound = message;
    truncate(message, random);
    ASSERT_LT(message.size(), sound.size());
    ASSERT_TRUE(std::equal(message.begin(), message.end(), sound.begin()));
  }
}

TEST(Damage, OneByteIsCutToNothingAndNothingStaysNothing) {
  RandomStream random(1, "dvl", "truncate");
  Message one{1}, none;
  truncate(one, random);
  truncate(none, random);
  flip_bit(none, random);
  flip_header_bit(none, random);
  break_checksum(none);
  EXPECT_TRUE(one.empty());
  EXPECT_TRUE(none.empty());
}

TEST(Damage, ABrokenChecksumLeavesWhatItProtectsAlone) {
  // The ZDA example of the standard; its checksum is 60 hexadecimal.
  Message sentence = bytes("$GPZDA,201530.00,04,07,2002,00,00*60\r\n");
  const Message sound = sentence;
  break_checksum(sentence);
  const auto star = static_cast<std::ptrdiff_t>(sound.size()) - 5;
  EXPECT_TRUE(std::equal(sound.begin(), sound.begin() + star + 1, sentence.begin()));
  EXPECT_NE(sentence, sound);
  EXPECT_EQ(sentence.size(), sound.size());

  Message binary{0x7F, 0x7F, 1, 2, 3, 0x34, 0x12};
  break_checksum(binary);
  EXPECT_THAT(binary, ElementsAre(0x7F, 0x7F, 1, 2, 3, 0x34, 0xED));
}

TEST(Damage, AtTheSameBaudEveryByteIsHeardAsItWasSent) {
  Message all(256);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  EXPECT_THAT(heard_at(all, 38400, 38400), ElementsAreArray(all));
  // A UART tolerates 2.5 %: both sides together may differ by 5 %, half a bit in the ten of a
  // character.
  EXPECT_THAT(heard_at(all, 38400 * 1.025, 38400), ElementsAreArray(all));
}

TEST(Damage, AtHalfTheBaudTwoCharactersAreHeardAsOne) {
  // "UU" is 0 10101010 1, twice. The samples at bits 3, 5, ... 17 are all high, and so is the stop
  // bit at 19.
  EXPECT_THAT(heard_at(bytes("UU"), 9600, 4800), ElementsAre(0xFF));
}

TEST(Damage, AParityBitMovesWhatIsHeardAtHalfTheBaud) {
  // "UU" with even parity is 0 10101010 0 1, twice. Of the samples at bits 3, 5, ... 17 the first
  // three are high; the stop bit is sampled at 21.
  constexpr wire::ByteFrame even{8, wire::Parity::even, 1};
  EXPECT_THAT(heard_at(bytes("UU"), 9600, {4800, even}), ElementsAre(0x07));
}

TEST(Damage, AtTheSameBaudEveryFramingHearsWhatWasSent) {
  Message all(128);
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::uint8_t>(i);
  using enum wire::Parity;
  for (const auto parity : {none, even, odd, mark, space})
    for (const unsigned stop_bits : {1u, 2u})
      EXPECT_THAT(heard_at(all, 38400, {38400, {7, parity, stop_bits}}), ElementsAreArray(all));
}

TEST(Damage, ACharacterWithoutItsStopBitIsReadAsZero) {
  // A receiver at twice the rate samples its stop bit on the sender's fourth bit, which is 0 in
  // "U".
  EXPECT_EQ(heard_at(bytes("U"), 4800, 9600).front(), 0);
  // A long break (all low) is one framing error, not hundreds.
  EXPECT_THAT(heard_at(Message{0}, 300, 115200), ElementsAre(0));
}

TEST(Damage, AFrameOfGarbageIsOneThatABusCanCarry) {
  RandomStream random(1, "imu", "garbage");
  for (int i = 0; i < 1000; ++i) {
    const auto frame = garbage_frame(4096, random);
    ASSERT_TRUE(frame.extended);
    ASSERT_LT(frame.id, 1u << 29);
    ASSERT_EQ(frame.size, 8);
  }
}

}  // namespace damage_test
}  // namespace drydock::fault::test
