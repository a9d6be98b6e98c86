#include <gmock/gmock.h>

#include "tests/drivers/link/scripted_adapter.hpp"

/// What the computer's end of an slcan link says to its adapter, and what it makes of the answers.
/// The commands are those of LAWICEL's CAN232 manual: C is refused while the channel is closed.
namespace drydock::link::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class SlcanOpening : public ::testing::Test {
 protected:
  std::unique_ptr<FrameLink> bus(const std::string& query = "") {
    return open_bus(io, "slcan:" + pty + query, Side::driver);
  }
  void wait_for(const ScriptedAdapter& adapter, const std::string& all) {
    run_until(io, [&] { return adapter.got() == all; });
    EXPECT_EQ(adapter.got(), all);
  }

  Folder folder;
  asio::io_context io;
  std::string pty = "pty:" + folder.file("can");
};

TEST_F(SlcanOpening, AListeningLinkOpensWithLAndClosesWithC) {
  ScriptedAdapter adapter(io, pty, {{"L", "\rt1231AA\r"}});
  const auto listening = bus("?bitrate=500000&listen=1");
  EXPECT_EQ(run(io, listening->read())->frame.id, 0x123U);
  EXPECT_EQ(adapter.got(), "\rC\rS6\rL\r");
  listening->close();
  wait_for(adapter, "\rC\rS6\rL\r\rC\r");
}

TEST_F(SlcanOpening, ModeListenIsTheSameAsListen1) {
  ScriptedAdapter adapter(io, pty, {{"L", "\rt1231AA\r"}});
  const auto listening = bus("?mode=listen");
  EXPECT_EQ(run(io, listening->read())->frame.id, 0x123U);
  EXPECT_FALSE(run(io, listening->write({})));
  EXPECT_EQ(adapter.got(), "\rC\rS5\rL\r");
}

/// A bus at 500 kbit/s: at 250 kbit/s the adapter hears nothing but errors (its report of error
/// passive; linux/drivers/net/can/slcan), and at the end of the channel before, frames of another
/// rate.
TEST_F(SlcanOpening, TheBitRateOfABusIsFoundByListening) {
  ScriptedAdapter adapter(io, pty,
                          {{"C", "t7FF0\r\r"}, {"S5 L", "\rsp128000\r"}, {"S6 L", "\rt1231AA\r"}});
  const auto searching = bus("?bitrate=auto&listen=1");
  EXPECT_EQ(searching->bit_rate(), std::nullopt);
  EXPECT_EQ(run(io, searching->read())->frame.id, 0x123U);
  EXPECT_EQ(adapter.got(), "\rC\rS5\rL\r\rC\rS6\rL\r");
  EXPECT_EQ(searching->bit_rate(), 500'000U);
  EXPECT_EQ(searching->note(), "500000 bit/s, found by listening");
}

TEST_F(SlcanOpening, ASearchLeavesOutTheRatesThatTheAdapterLacksAndSaysWhereItIs) {
  ScriptedAdapter adapter(io, pty, {{"S5", "\a"}, {"S6", "\a"}});
  const auto searching = bus("?bitrate=auto&listen=1");
  const auto read = start(io, searching->read());
  run_until(io, [&] { return adapter.got() == "\rC\rS5\rS6\rS4\rL\r"; });
  EXPECT_EQ(adapter.got(), "\rC\rS5\rS6\rS4\rL\r");
  EXPECT_THAT(searching->note(), AllOf(HasSubstr("no frame yet"), HasSubstr("125000 bit/s")));
  searching->close();
  run_until(io, [&] { return read->outcome.has_value(); });
}

TEST_F(SlcanOpening, AListeningLinkRefusesToWriteAndTheAdapterGetsNothing) {
  ScriptedAdapter adapter(io, pty, {{"L", "\rt1231AA\r"}});
  const auto listening = bus("?listen=1");
  ASSERT_TRUE(run(io, listening->read()));
  const auto written = run(io, listening->write({}));
  ASSERT_FALSE(written);
  EXPECT_THAT(written.error().message(), HasSubstr("listen=1"));
  settle(io);
  EXPECT_EQ(adapter.got(), "\rC\rS5\rL\r");
}

TEST_F(SlcanOpening, AnAdapterWithoutLIsNotOpenedAtAll) {
  ScriptedAdapter adapter(io, pty, {{"L", "\a"}});
  const auto listening = bus("?listen=1");
  const auto read = run(io, listening->read());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message(), AllOf(HasSubstr("refused L"), HasSubstr("not opened")));
  EXPECT_EQ(adapter.got(), "\rC\rS5\rL\r");
}

TEST_F(SlcanOpening, ARefusedRateIsNamedAndTheChannelStaysClosed) {
  ScriptedAdapter adapter(io, pty, {{"S7", "\a"}});
  const auto refused = bus("?bitrate=800000");
  const auto read = run(io, refused->read());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message(), AllOf(HasSubstr("refused S7"), HasSubstr("800000 bit/s")));
  EXPECT_EQ(adapter.got(), "\rC\rS7\r");
}

TEST_F(SlcanOpening, ARefusedOpeningIsNamed) {
  ScriptedAdapter adapter(io, pty, {{"O", "\a"}});
  const auto refused = bus();
  const auto read = run(io, refused->read());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message(), HasSubstr("refused O"));
}

TEST_F(SlcanOpening, AChannelThatWasClosedRefusesCAndOpensAllTheSame) {
  ScriptedAdapter adapter(io, pty, {{"", "\a"}, {"C", "\a"}, {"O", "\rt1231AA\r"}});
  const auto open = bus();
  EXPECT_EQ(run(io, open->read())->frame.id, 0x123U);
  EXPECT_EQ(adapter.got(), "\rC\rS5\rO\r");
  EXPECT_EQ(open->note(), "");
}

TEST_F(SlcanOpening, AnAdapterThatAnswersNothingIsToldApartAndUsed) {
  ScriptedAdapter adapter(io, pty, {{"O", "t1231AA\r"}}, "");
  const auto open = bus();
  EXPECT_EQ(run(io, open->read())->frame.id, 0x123U);
  EXPECT_EQ(adapter.got(), "\rC\rS5\rO\r");
  EXPECT_THAT(open->note(), HasSubstr("answers no command"));
}

TEST_F(SlcanOpening, AnAdapterThatFallsSilentIsAnErrorThatNamesTheCommand) {
  ScriptedAdapter adapter(io, pty, {{"S5", ""}});
  const auto read = run(io, bus()->read());
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message(), HasSubstr("no answer to S5"));
}

TEST_F(SlcanOpening, FramesOfTheChannelThatWasOpenBeforeAreNotOfThisOne) {
  ScriptedAdapter adapter(io, pty, {{"C", "t7FF0\r\r"}, {"O", "\rt1231AA\r"}});
  const auto open = bus();
  EXPECT_EQ(run(io, open->read())->frame.id, 0x123U);
}

/// A terminal, or a pty that was not set raw, repeats each line before the answer to it.
TEST_F(SlcanOpening, OwnFramesThatAnAdapterRepeatsAreNotThoseOfAnotherNode) {
  ScriptedAdapter adapter(
      io, pty,
      {{"C", "C\r\r"}, {"S5", "S5\r\r"}, {"O", "O\r\r"}, {"t1231AA", "t1231AA\rz\rt1231BB\r"}});
  const auto open = bus();
  wire::CanFrame own;
  own.id = 0x123;
  own.size = 1;
  own.data[0] = 0xAA;
  ASSERT_TRUE(run(io, open->write(own)));
  const auto heard = run(io, open->read());
  ASSERT_TRUE(heard);
  EXPECT_EQ(heard->frame.data[0], 0xBB);
}

/// F answers with the status flags, V with the version, N with the serial number.
TEST_F(SlcanOpening, AnswersToTheQuestionsOfAnEarlierProgramAreNoFrames) {
  ScriptedAdapter adapter(io, pty, {{"O", "\rF08\rV1013\rNA123\rCANable 1.2\rt1231AA\r"}});
  const auto open = bus();
  EXPECT_EQ(run(io, open->read())->frame.id, 0x123U);
}

TEST_F(SlcanOpening, AChannelThatWasLeftOpenAmidALineIsNoDamage) {
  ScriptedAdapter adapter(io, pty, {{"", "AABBCC\rt1232"}, {"C", "AA\r\r"}, {"O", "\rt1231AA\r"}});
  const auto open = bus();
  EXPECT_EQ(run(io, open->read())->frame.id, 0x123U);
  EXPECT_EQ(open->note(), "");
}

TEST_F(SlcanOpening, LinesThatTheSerialLineDamagesAreCountedAndSaid) {
  ScriptedAdapter adapter(io, pty, {{"O", "\rt1231AA\r"}, {"t0010", "z\rt12\rt1232A\rt1231BB\r"}});
  const auto open = bus();
  ASSERT_TRUE(run(io, open->read()));
  wire::CanFrame own;
  own.id = 1;
  ASSERT_TRUE(run(io, open->write(own)));
  EXPECT_EQ(run(io, open->read())->frame.data[0], 0xBB);
  EXPECT_THAT(open->note(), HasSubstr("2 damaged lines"));
}

/// The stamps of Z1 are four digits more; the link's own time of arrival serves.
TEST_F(SlcanOpening, TimeStampsThatAnEarlierProgramTurnedOnAreNoData) {
  ScriptedAdapter adapter(io, pty, {{"O", "\rt1232AABB0A1B\rT1CFF00FF101EA5F\r"}});
  const auto open = bus();
  const auto first = run(io, open->read());
  ASSERT_TRUE(first);
  EXPECT_EQ(first->frame.size, 2);
  const auto second = run(io, open->read());
  ASSERT_TRUE(second);
  EXPECT_EQ(second->frame.id, 0x1CFF00FFU);
  EXPECT_EQ(second->frame.size, 1);
}

TEST_F(SlcanOpening, TheEmulatedAdapterRefusesFramesOfCanFd) {
  const auto device = open_bus(io, "slcan:" + pty, Side::device);
  const auto program = open(io, pty, Side::driver);
  ASSERT_TRUE(run(io, program->write(bytes("O\rd1231AA\r"))));
  EXPECT_EQ(run(io, read_bytes(*program, 2)).value(), bytes("\r\a"));
}

TEST_F(SlcanOpening, TheEmulatedAdapterOnlyListensAfterL) {
  const auto device = open_bus(io, "slcan:" + pty, Side::device);
  const auto program = open(io, pty, Side::driver);
  ASSERT_TRUE(run(io, program->write(bytes("S5\rL\rt1230\r"))));
  EXPECT_EQ(run(io, read_bytes(*program, 3)).value(), bytes("\r\r\a"));
}

/// It was reset, or another program told it C: it says nothing until it is opened again.
TEST_F(SlcanOpening, AnAdapterThatFellSilentIsOpenedAgain) {
  ScriptedAdapter adapter(io, pty, {});
  const auto silent = bus();
  const auto read = start(io, silent->read());
  const std::string opening = "\rC\rS5\rO\r";
  run_until(io, [&] { return adapter.got().size() >= 2 * opening.size(); });
  EXPECT_EQ(adapter.got(), opening + opening);
  EXPECT_FALSE(read->outcome);
  silent->close();
  run_until(io, [&] { return read->outcome.has_value(); });
}

TEST(ListeningLinks, EveryKindOfBusReadsAndRefusesToWrite) {
  asio::io_context io;
  const auto device = open_bus(io, "memory-can:listened", Side::device);
  const auto listening = open_bus(io, "memory-can:listened?listen=1", Side::driver);
  wire::CanFrame frame;
  frame.id = 0x123;
  ASSERT_TRUE(run(io, device->write(frame)));
  EXPECT_EQ(run(io, listening->read())->frame.id, 0x123U);
  EXPECT_FALSE(run(io, listening->write(frame)));
}

TEST(ListeningLinks, TheDevicesEndOfTheSameUriStillSends) {
  asio::io_context io;
  const auto device = open_bus(io, "memory-can:sender?listen=1", Side::device);
  EXPECT_TRUE(run(io, device->write({})));
}

}  // namespace
}  // namespace drydock::link::testing
