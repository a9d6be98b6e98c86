#include "drivers/capture/formats/ip_fragments.hpp"

#include <gtest/gtest.h>

#include <random>

#include "drivers/capture/formats/network_segment.hpp"
#include "drivers/wire/bytes.hpp"
#include "tests/drivers/wire/byte_streams.hpp"

/// Fragments as RFC 791 lays them out.
namespace drydock::capture::testing {
namespace ip_fragments_test {

using wire::testing::Buffer;

/// A datagram of UDP from 10.0.0.2:1033 to 10.0.0.9:1034 with so many bytes, in fragments of 1480.
std::vector<Buffer> fragments_of(std::size_t size, std::uint16_t identification) {
  Buffer payload(8 + size);
  wire::store_be<std::uint16_t>(payload, 0, 1033);
  wire::store_be<std::uint16_t>(payload, 2, 1034);
  wire::store_be<std::uint16_t>(payload, 4, static_cast<std::uint16_t>(payload.size()));
  for (std::size_t i = 8; i < payload.size(); ++i) payload[i] = static_cast<std::uint8_t>(i * 7);
  std::vector<Buffer> fragments;
  for (std::size_t at = 0; at < payload.size(); at += 1480) {
    const std::size_t piece = std::min<std::size_t>(1480, payload.size() - at);
    Buffer packet{0x45, 0, 0, 0, 0, 0, 0, 0, 64, 17, 0, 0, 10, 0, 0, 2, 10, 0, 0, 9};
    wire::store_be<std::uint16_t>(packet, 2, static_cast<std::uint16_t>(20 + piece));
    wire::store_be<std::uint16_t>(packet, 4, identification);
    const bool more = at + piece < payload.size();
    wire::store_be<std::uint16_t>(packet, 6,
                                  static_cast<std::uint16_t>(at / 8 | (more ? 0x2000 : 0)));
    packet.insert(packet.end(), payload.begin() + static_cast<std::ptrdiff_t>(at),
                  payload.begin() + static_cast<std::ptrdiff_t>(at + piece));
    fragments.push_back(std::move(packet));
  }
  return fragments;
}

TEST(IpFragments, InAnyOrderMakeTheirDatagram) {
  auto pieces = fragments_of(5000, 1);
  ASSERT_EQ(pieces.size(), 4u);
  std::mt19937 order{1};
  IpFragments fragments;
  for (int round = 0; round < 20; ++round) {
    std::ranges::shuffle(pieces, order);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      EXPECT_TRUE(is_ipv4_fragment(pieces[i]));
      const auto whole = fragments.take(pieces[i], {});
      ASSERT_EQ(whole.has_value(), i + 1 == pieces.size());
      if (!whole) continue;
      const auto segment = network_segment({protocol_ipv4, *whole});
      ASSERT_TRUE(segment);
      EXPECT_EQ(segment->sender, "10.0.0.2:1033");
      ASSERT_EQ(segment->payload.size(), 5000u);
      for (std::size_t k = 0; k < 5000; ++k)
        ASSERT_EQ(segment->payload[k], static_cast<std::uint8_t>((k + 8) * 7)) << k;
    }
  }
  EXPECT_EQ(fragments.left_over("*"), 0u);
}

TEST(IpFragments, OfDatagramsThatAreNotWholeAreCounted) {
  IpFragments fragments;
  for (std::uint16_t id = 0; id < 100; ++id) {
    auto pieces = fragments_of(2000, id);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_FALSE(fragments.take(pieces[id % 2], {}));
  }
  EXPECT_EQ(fragments.left_over("*"), 100u);
  EXPECT_EQ(fragments.left_over("10.0.0.2"), 100u);
  EXPECT_EQ(fragments.left_over("10.0.0.9"), 0u);
}

TEST(IpFragments, OfOneThatIsCutShortMakeNoDatagram) {
  IpFragments fragments;
  auto pieces = fragments_of(2000, 1);
  pieces[0].resize(96);
  EXPECT_FALSE(fragments.take(pieces[0], {}));
  EXPECT_FALSE(fragments.take(pieces[1], {}));
  EXPECT_EQ(fragments.left_over("10.0.0.2"), 2u);
}

TEST(IpFragments, OfTwoDatagramsWithOneNumberAreNotMixedHalfAMinuteLater) {
  IpFragments fragments;
  const auto pieces = fragments_of(2000, 1);
  EXPECT_FALSE(fragments.take(pieces[0], std::chrono::seconds{0}));
  EXPECT_FALSE(fragments.take(pieces[1], std::chrono::seconds{100}));
  EXPECT_EQ(fragments.left_over("*"), 2u);
}

}  // namespace ip_fragments_test
}  // namespace drydock::capture::testing
