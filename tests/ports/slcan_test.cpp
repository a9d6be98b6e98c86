// slcan adapters in every state in which a program may find one, behind the kernel's drivers for a
// 16550A and an FTDI adapter.
#include <gmock/gmock.h>

#include "tests/drivers/link/scripted_adapter.hpp"
#include "tests/ports/driver.hpp"

namespace drydock::ports {
namespace {

using link::Side;
using link::testing::ScriptedAdapter;

struct Found {
  std::string name;
  ScriptedAdapter::Script answers;
  std::string otherwise, note;
};

/// Each adapter gives the frame 123h with the one byte AAh once its channel is open, and nothing
/// else that is a frame of this channel.
std::vector<Found> states() {
  const std::string frame = "t1231AA\r";
  return {{"ordinary", {{"O", "\r" + frame}}, "\r", ""},
          {"closed_before", {{"", "\a"}, {"C", "\a"}, {"O", "\r" + frame}}, "\r", ""},
          {"left_open_amid_a_line", {{"", "AABB\rt7FF0\rt1232"}, {"O", "\r" + frame}}, "\r", ""},
          {"echoes", {{"C", "C\r\r"}, {"S5", "S5\r\r"}, {"O", "O\r\r" + frame}}, "\r", ""},
          {"silent", {{"O", frame}}, "", "answers no command"},
          {"tells_of_itself", {{"O", "\rF08\rV1013\rNA123\r" + frame}}, "\r", ""},
          {"stamps_its_frames", {{"O", "\rt1231AA0A1B\r"}}, "\r", ""},
          {"damages_lines", {{"O", "\r"}, {"t0010", "z\rt12\r" + frame}}, "\r", "1 damaged lines"}};
}

class AnAdapter : public ::testing::TestWithParam<std::tuple<const char*, Found>> {};

TEST_P(AnAdapter, IsOpenedAndItsFrameHeard) {
  const auto& [ports, state] = GetParam();
  const std::string ours = std::string("/dev/tty") + ports,
                    theirs = ours == "/dev/ttyS1" ? "/dev/ttyS2" : "/dev/ttyUSB1";
  runs_on({ours, theirs});
  boost::asio::io_context io;
  ScriptedAdapter adapter(io, "serial:" + theirs + "?emulated=1&baud=115200", state.answers,
                          state.otherwise);
  const auto bus = link::testing::open_bus(io, "slcan:" + ours + "?emulated=1", Side::driver);
  ASSERT_TRUE(bus);
  wire::CanFrame asked;
  asked.id = 1;
  ASSERT_TRUE(link::testing::run(io, bus->write(asked)));
  const auto heard = link::testing::run(io, bus->read());
  ASSERT_TRUE(heard) << heard.error().message();
  EXPECT_EQ(heard->frame.id, 0x123U);
  EXPECT_EQ(heard->frame.payload().front(), 0xAA);
  EXPECT_THAT(std::string(bus->note()), ::testing::HasSubstr(state.note));
  EXPECT_EQ(bus->note().empty(), state.note.empty());
}

INSTANTIATE_TEST_SUITE_P(Ports, AnAdapter,
                         ::testing::Combine(::testing::Values("S1", "USB0"),
                                            ::testing::ValuesIn(states())),
                         [](const auto& one) {
                           return std::string(std::get<0>(one.param)) + "_" +
                                  std::get<1>(one.param).name;
                         });

}  // namespace
}  // namespace drydock::ports
