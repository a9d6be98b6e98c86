#include <gmock/gmock.h>

#include <cmath>

#include "drivers/wire/bytes.hpp"
#include "tests/hil/emulate/bench.hpp"

/// The command line of an RDI DVL, as other programs use it. Read for these facts: the simulator
/// and drivers of the Ocean Observatories Initiative (texts of greeting, prompt and errors), DUNE's
/// RDI driver (a break, the line "[BREAK Wakeup A]", then the prompt), avbotz/Nautical (===, CR1,
/// settings, CK, cs).
namespace drydock::emulate {
namespace rdi_dialogue_test {

using rig_config::DeviceKind;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

/// A host on the line of an emulated DVL, without pacing.
struct Host : Wire {
  explicit Host(const std::string& protocol = "pd0",
                rig_config::DvlMaker maker = rig_config::DvlMaker::teledyne) {
    auto config = device(DeviceKind::dvl, protocol, 5);
    config.maker = maker;
    dvl_ = make_emulated_device(config, trajectory_, 1).value();
  }
  void send(wire::Bytes bytes) override { sent.emplace_back(bytes.begin(), bytes.end()); }
  void send(const wire::CanFrame&) override {}
  void set_baud(unsigned rate) override { bauds.push_back(rate); }
  void tell(std::string_view what) override { told.emplace_back(what); }

  std::string says(std::string_view text) {
    sent.clear();
    dvl_->receive({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, now, *this);
    std::string all;
    for (const auto& part : sent) all += part;
    return all;
  }
  /// The ensembles of the next seconds.
  std::size_t ensembles(double seconds) {
    sent.clear();
    const Stamp end = now + measurement::from_seconds(seconds);
    while (*dvl_->deadline() <= end) {
      now = *dvl_->deadline();
      dvl_->tick(now, *this);
    }
    now = end;
    return sent.size();
  }

  std::vector<std::string> sent, told;
  std::vector<unsigned> bauds;
  Stamp now = start;

 private:
  Frozen trajectory_{under_way()};
  std::unique_ptr<EmulatedDevice> dvl_;
};

TEST(RdiDialogue, ABreakStopsThePingsAndIsGreeted) {
  for (const std::string protocol : {"pd0", "pd4", "pd5", "pd6"}) {
    Host host(protocol);
    EXPECT_EQ(host.ensembles(0.9), 5u) << "it pings from power on";
    EXPECT_EQ(host.says("CR1\r"), "") << "and hears nothing but a break";
    const auto greeting = host.says("===");
    EXPECT_THAT(greeting, StartsWith("\r\n[BREAK Wakeup A]\r\n"));
    EXPECT_THAT(greeting, EndsWith("\r\n>"));
    EXPECT_EQ(host.ensembles(10), 0u);
    EXPECT_EQ(host.says("cs\r"), "cs\r\n");
    EXPECT_EQ(host.ensembles(1), 5u);
  }
}

/// "+++" is the break of a deck box; a port reads a real break as a zero byte.
TEST(RdiDialogue, OtherBreaksAreHeardToo) {
  const std::string zero(1, '\0');
  EXPECT_THAT(Host().says(zero), HasSubstr("[BREAK Wakeup A]")) << "while it pings";
  Host host;
  EXPECT_THAT(host.says("+++"), HasSubstr("[BREAK Wakeup A]"));
  EXPECT_THAT(host.says("C" + zero), HasSubstr("[BREAK Wakeup A]")) << "while it listens";
  EXPECT_EQ(host.says("="), "=");
  EXPECT_EQ(host.says("="), "=");
  EXPECT_THAT(host.says("="), HasSubstr("[BREAK Wakeup A]"));
}

/// A port that is opened for the first time echoes its first bytes (tty_std_termios of Linux).
TEST(RdiDialogue, ItsOwnBytesInAnEchoAreNoBreak) {
  Host host;
  host.ensembles(1);
  const std::string echo = host.sent.at(0);
  ASSERT_THAT(echo, HasSubstr(std::string(1, '\0')));
  for (const char byte : echo) EXPECT_EQ(host.says({&byte, 1}), "");
  EXPECT_EQ(host.ensembles(1), 5u);
}

TEST(RdiDialogue, EachLineIsEchoedAndAnsweredWithThePrompt) {
  Host host;
  host.says("===");
  EXPECT_EQ(host.says("\r"), "\r\n>");
  EXPECT_EQ(host.says("\n"), "") << "the second half of a line end";
  EXPECT_EQ(host.says("CR1\r\n"), "CR1\r\n[Parameters set to FACTORY defaults]\r\n>");
  EXPECT_EQ(host.says("CR0\r"), "CR0\r\n[Parameters set to USER defaults]\r\n>");
  EXPECT_EQ(host.says("EA-04500\r"), "EA-04500\r\n>");
  EXPECT_EQ(host.says("#BJ000110000\r"), "#BJ000110000\r\n>");
  EXPECT_EQ(host.says("EA?\r"), "EA?\r\nEA = -04500\r\n>");
  EXPECT_EQ(host.says("CK\n"), "CK\r\n[Parameters saved as USER defaults]\r\n>");
  EXPECT_EQ(host.says("ES00\r"), "ES00\r\n>");
  EXPECT_EQ(host.says("CR0\rEA?\r"),
            "CR0\r\n[Parameters set to USER defaults]\r\n>EA?\r\nEA = -04500\r\n>");
  EXPECT_THAT(host.told,
              ElementsAre("CR1", "CR0", "EA-04500", "#BJ000110000", "CK", "ES00", "CR0"));
}

TEST(RdiDialogue, WhatIsWrongHasItsNumber) {
  Host host("pd6");
  host.says("===");
  EXPECT_EQ(host.says("QQ1\r"), "QQ1 ERR 010:  UNRECOGNIZED COMMAND\r\n>");
  EXPECT_EQ(host.says("BXabc\r"), "BXabc ERR 002:  NUMERAL EXPECTED\r\n>");
  EXPECT_EQ(host.says("PD0\r"), "PD0 ERR 001:  PARAMETER OUT OF BOUNDS\r\n>") << "it keeps PD6";
  EXPECT_EQ(host.says("PD6\r"), "PD6\r\n>");
}

TEST(RdiDialogue, CbChangesTheRateOfTheLine) {
  Host host;
  host.says("===");
  EXPECT_EQ(host.says("CB811\r"), "CB811\r\n>");
  EXPECT_THAT(host.bauds, ElementsAre(115200u));
  EXPECT_THAT(host.says("CB911\r"), HasSubstr("ERR 001"));
}

/// 30 m above the bed: with 100 decimetres it is not found any more, until CR1.
TEST(RdiDialogue, BxEndsTheSearchForTheBed) {
  Host host;
  const auto velocity = [&] {
    host.says("CS\r");
    EXPECT_GT(host.ensembles(1), 0u);
    const auto& bytes = host.sent.back();
    for (std::size_t i = 0; i < static_cast<unsigned char>(bytes[5]); ++i) {
      const wire::Bytes all{reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()};
      const auto offset = wire::load_le<std::uint16_t>(all, 6 + 2 * i);
      if (wire::load_le<std::uint16_t>(all, offset) == 0x0600)
        return int{wire::load_le<std::int16_t>(all, offset + 26)};
    }
    return 0;
  };
  host.says("===");
  EXPECT_EQ(velocity(), -2000);
  host.says("===BX00100\r");
  EXPECT_EQ(velocity(), -32768);
  host.says("===CR1\r");
  EXPECT_EQ(velocity(), -2000);
}

TEST(RdiDialogue, WithoutACommandForFiveMinutesItPingsAgain) {
  Host host;
  host.says("===");
  EXPECT_EQ(host.ensembles(299), 0u);
  EXPECT_EQ(host.ensembles(11), 50u + 1);
  host.says("===CZ\r");
  EXPECT_EQ(host.ensembles(400), 0u) << "it sleeps";
  EXPECT_EQ(host.says("CS\r"), "");
  host.says("===CS\r");
  EXPECT_EQ(host.ensembles(1), 5u);
}

TEST(RdiDialogue, AHeadOfAnotherMakerHasNone) {
  Host host("pd6", rig_config::DvlMaker::water_linked);
  EXPECT_EQ(host.says("===CR1\r"), "");
  EXPECT_EQ(host.ensembles(0.9), 5u);
}

}  // namespace rdi_dialogue_test
}  // namespace drydock::emulate
