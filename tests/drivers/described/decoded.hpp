#pragma once

#include "tests/drivers/described/support.hpp"

namespace drydock::described::test {

/// The record of one whole frame.
inline wire::described::Record decoded(const DescriptionPtr& description,
                                       const wire::testing::Buffer& frame) {
  const auto text = wire::testing::as_text(frame);
  EXPECT_EQ(wire::described::scan(description->plan, frame), wire::Scan::frame(frame.size()))
      << text;
  wire::described::Record record;
  EXPECT_EQ(wire::described::decode(description->plan, frame, record),
            wire::described::Decoded::message)
      << text;
  return record;
}

inline wire::described::Record decoded(const DescriptionPtr& description, std::string_view text) {
  return decoded(description, wire::testing::as_bytes(text));
}

}  // namespace drydock::described::test
