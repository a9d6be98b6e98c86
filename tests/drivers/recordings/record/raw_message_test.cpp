#include "drivers/recordings/record/raw_message.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace drydock::record {
namespace raw_message_test {

constexpr Stamp at = measurement::stamp_from_ns(1'700'000'000'123'456'789);

TEST(RawMessage, BytesStandWhereCdrPutsThem) {
  const std::array<std::uint8_t, 3> data{0xAA, 0xBB, 0xCC};
  std::vector<std::uint8_t> cdr;
  encode(cdr, RawBytes{at, Direction::sent, data});
  const std::vector<std::uint8_t> expected{0,    1,    0,    0,     // plain, little endian
                                           0x00, 0xF1, 0x53, 0x65,  // 1 700 000 000 s
                                           0x15, 0xCD, 0x5B, 0x07,  // 123 456 789 ns
                                           1,    0,    0,    0,     // sent, padding
                                           3,    0,    0,    0,    0xAA, 0xBB, 0xCC};  // sequence
  EXPECT_EQ(cdr, expected);
}

RC_GTEST_PROP(RawMessage, OfAnyFrameComesBack, ()) {
  wire::CanFrame frame;
  frame.id = *rc::gen::inRange<std::uint32_t>(0, 1u << 29);
  frame.extended = *rc::gen::arbitrary<bool>();
  frame.remote = *rc::gen::arbitrary<bool>();
  frame.error = *rc::gen::arbitrary<bool>();
  frame.fd = *rc::gen::arbitrary<bool>();
  frame.bit_rate_switch = *rc::gen::arbitrary<bool>();
  frame.size = *rc::gen::inRange<std::uint8_t>(0, 65);
  for (std::size_t i = 0; i < frame.size; ++i) frame.data[i] = *rc::gen::arbitrary<std::uint8_t>();
  std::vector<std::uint8_t> cdr;
  encode(cdr, RawFrame{at, Direction::received, frame});
  const auto back = decode_frame(cdr);
  RC_ASSERT(back.has_value());
  RC_ASSERT(back->at == at);
  RC_ASSERT(back->direction == Direction::received);
  RC_ASSERT(back->frame == frame);
}

RC_GTEST_PROP(RawMessage, OfAnyLengthButItsOwnIsRefused, ()) {
  const auto data = *rc::gen::arbitrary<std::vector<std::uint8_t>>();
  std::vector<std::uint8_t> cdr;
  encode(cdr, RawBytes{at, Direction::received, data});
  RC_ASSERT(decode_bytes(cdr).has_value());
  const auto size = *rc::gen::inRange<std::size_t>(0, cdr.size());
  RC_ASSERT(!decode_bytes(Bytes(cdr).first(size)).has_value());
}

}  // namespace raw_message_test
}  // namespace drydock::record
