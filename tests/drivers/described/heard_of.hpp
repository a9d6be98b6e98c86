#pragma once

#include "tests/drivers/described/driven.hpp"

namespace drydock::described::test {

/// What the driver of the shipped description says of the bytes.
inline Heard heard_of(const std::string& description, const std::string& stream) {
  Heard heard;
  receive(*driver_of(shipped(description)), stream, {}, heard);
  return heard;
}

/// Of fixtures/described; NOTE.md there tells where they are from.
inline Heard heard_of_fixture(const std::string& description, const std::string& file) {
  const auto bytes = wire::testing::fixture("described/" + file);
  return heard_of(description, std::string(bytes.begin(), bytes.end()));
}

}  // namespace drydock::described::test
