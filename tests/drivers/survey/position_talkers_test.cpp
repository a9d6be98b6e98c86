#include "drivers/survey/position_talkers.hpp"

#include <gtest/gtest.h>

#include "tests/drivers/wire/byte_streams.hpp"
#include "tests/drivers/wire/sentences.hpp"

/// Several receivers on one line are told by their talkers.
namespace drydock::survey {
namespace position_talkers_test {

using wire::testing::as_bytes;
using wire::testing::sentence;

std::string note_of(const std::vector<std::string>& bodies) {
  std::string line;
  for (int i = 0; i < 4; ++i)
    for (const auto& body : bodies) line += sentence(body);
  ByteSurvey survey;
  survey.feed(as_bytes(line), Stamp{});
  survey.finish();
  return note_of_receivers(survey.best());
}

const std::string rest = "RMC,120000.00,A,4916.0000,N,12311.0000,W,1.0,090.0,180320,,,A";

TEST(PositionTalkers, OfTwoReceiversAreNamedWithTheOneThatTheDriverTakes) {
  EXPECT_EQ(note_of({"II" + rest, "GP" + rest}),
            "2 receivers tell positions on this line, with the talkers GP, II: the gnss driver "
            "takes GP, and another one when that is silent");
}

TEST(PositionTalkers, OfOneReceiverAreNoNews) {
  EXPECT_EQ(note_of({"GP" + rest, "GN" + rest, "GL" + rest}), "");
  EXPECT_EQ(note_of({"GP" + rest, "IIVTG,180.0,T,,M,1.0,N,,K", "HEHDT,10.0,T"}), "");
}

}  // namespace position_talkers_test
}  // namespace drydock::survey
