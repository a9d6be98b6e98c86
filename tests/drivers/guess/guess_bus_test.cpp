#include <fmt/format.h>
#include <gmock/gmock.h>

#include "drivers/guess/bus_guess.hpp"
#include "drivers/wire/bytes.hpp"
#include "drivers/wire/dbc/plan.hpp"
#include "drivers/wire/dbc/reader.hpp"

/// A first DBC file of a bus that nobody knows.
namespace drydock::described::test {
namespace guess_bus_test {

using namespace std::chrono_literals;
using ::testing::HasSubstr;

/// Every 10 ms: a big-endian number that rises by 300, a constant, a counter in four bits.
std::string guess_of_made_bus() {
  guess::BusGuess guess;
  for (int i = 0; i < 50; ++i) {
    wire::CanFrame frame;
    frame.id = 0x123;
    frame.size = 4;
    wire::store_be<std::int16_t>(frame.data, 0, static_cast<std::int16_t>(-6000 + 300 * i));
    frame.data[2] = 0x5A;
    frame.data[3] = static_cast<std::uint8_t>(0xC0 | i % 16);
    guess.take(frame, 10ms * i);
  }
  return guess.dbc();
}

TEST(GuessedBus, GivesIdentifiersPeriodsAndTheBitsThatChange) {
  const std::string dbc = guess_of_made_bus();
  EXPECT_THAT(dbc, HasSubstr("nothing here is certain"));
  EXPECT_THAT(dbc, HasSubstr("BO_ 291 id_123: 4 Vector__XXX"));
  EXPECT_THAT(dbc, HasSubstr("50 frames, one in 10 ms; bits that change: "));
  EXPECT_THAT(dbc, HasSubstr("BA_ \"GenMsgCycleTime\" BO_ 291 10;"));
  EXPECT_THAT(dbc, HasSubstr("SG_ counter_3 : 24|4@1+"));
  EXPECT_THAT(dbc, HasSubstr("00 0F; the first: E8 90 5A C0"));
}

TEST(GuessedBus, IsADbcFileThatReadsTheNumbersAgain) {
  const auto read = wire::dbc::read(guess_of_made_bus());
  ASSERT_TRUE(read.errors.empty()) << read.errors.front().text;
  ASSERT_EQ(read.database.messages.size(), 1u);
  const auto& message = read.database.messages[0];
  ASSERT_EQ(message.signals[0].name, "number_0");
  std::vector<wire::dbc::Value> values(message.signals.size());
  const std::array<std::uint8_t, 4> payload{0xFF, 0x38, 0x5A, 0xC3};
  wire::dbc::Plan(message).decode(payload, values);
  EXPECT_EQ(values[0].physical, -200);
  EXPECT_EQ(values[1].physical, 3);
}

/// VFrameFormat: 0 StandardCAN, 1 ExtendedCAN, 14 StandardCAN_FD, 15 ExtendedCAN_FD.
TEST(GuessedBus, SaysOfWhichFormatItsFramesAre) {
  for (const bool extended : {false, true})
    for (const bool fd : {false, true}) {
      guess::BusGuess guess;
      for (int i = 0; i < 20; ++i) {
        wire::CanFrame frame;
        frame.id = 0x123;
        frame.extended = extended;
        frame.fd = fd;
        frame.size = 8;
        frame.data[0] = static_cast<std::uint8_t>(7 * i);
        guess.take(frame, 10ms * i);
      }
      const std::string value =
          fmt::format("BA_ \"VFrameFormat\" BO_ {} {};", extended ? 0x80000123U : 0x123U,
                      (fd ? 14 : 0) + (extended ? 1 : 0));
      EXPECT_EQ(guess.dbc().find(value) != std::string::npos, extended || fd) << value;
    }
}

TEST(GuessedBus, WithoutFramesGivesNothing) { EXPECT_EQ(guess::BusGuess().dbc(), ""); }

}  // namespace guess_bus_test
}  // namespace drydock::described::test
