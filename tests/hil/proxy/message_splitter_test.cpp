#include "hil/fault/wire/message_splitter.hpp"

#include <gtest/gtest.h>

#include "rig_config/device_description/load_description.hpp"
#include "tests/drivers/property.hpp"
#include "tests/hil/proxy/outlet.hpp"

namespace message_splitter_test {

using namespace drydock;
using namespace drydock::fault;
using namespace drydock::fault::testing;

struct Pieces {
  std::vector<std::string> messages, between;
  std::string all;
  MessageSplitter::OnPiece taker = [this](const MessageSplitter::Piece& piece) {
    const std::string text(piece.bytes.begin(), piece.bytes.end());
    (piece.message ? messages : between).push_back(text);
    all += text;
  };
};

rig_config::DeviceConfig speaking(const std::string& protocol) {
  rig_config::DeviceConfig device;
  device.protocol = protocol;
  return device;
}

MessageSplitter splitter(const std::string& protocol) {
  return MessageSplitter(*MessageSplitter::protocol(speaking(protocol)));
}

TEST(MessageSplitter, KnowsTheByteProtocolsByName) {
  for (const char* name : {"nmea0183", "ubx", "pd0", "pd4", "pd5", "pd6", "water-linked",
                           "water-linked-json", "nortek", "nortek-ad2cp", "wayfinder"})
    EXPECT_TRUE(MessageSplitter::protocol(speaking(name))) << name;
  EXPECT_FALSE(MessageSplitter::protocol(speaking("xsens")));
  EXPECT_FALSE(MessageSplitter::protocol(speaking("")));
}

TEST(MessageSplitter, KnowsTheMessagesOfADescription) {
  auto device = speaking("valeport-vat.toml");
  device.description = *rig_config::find_description("valeport-vat.toml", "no-such-folder/");
  MessageSplitter split(*MessageSplitter::protocol(device));
  Pieces pieces;
  const std::string sentence = "$PRVAT,00.115,M,0010.073,dBar*39\r\n";
  split.feed(bytes_of("boot " + sentence + sentence.substr(0, 9)), pieces.taker);
  EXPECT_EQ(pieces.messages, std::vector{sentence});
  EXPECT_EQ(pieces.between, std::vector<std::string>{"boot "});
  EXPECT_FALSE(split.empty()) << "an incomplete message waits";
}

TEST(MessageSplitter, GivesFramesAndWhatIsBetweenThemInOrder) {
  auto split = splitter("nmea0183");
  Pieces pieces;
  split.feed(bytes_of("boot " + gga + "noise" + rmc), pieces.taker);
  EXPECT_EQ(pieces.messages, (std::vector{gga, rmc}));
  EXPECT_EQ(pieces.between, (std::vector<std::string>{"boot ", "noise"}));
  EXPECT_EQ(pieces.all, "boot " + gga + "noise" + rmc);
  EXPECT_TRUE(split.empty());
}

TEST(MessageSplitter, TellsHowManyBytesOfTheReadCameAfterAFrame) {
  auto split = splitter("nmea0183");
  std::vector<std::size_t> after;
  const auto note = [&](const auto& piece) { after.push_back(piece.after); };
  split.feed(bytes_of(gga.substr(0, 10)), note);
  split.feed(bytes_of(gga.substr(10) + rmc + "$GP"), note);
  EXPECT_EQ(after, (std::vector<std::size_t>{rmc.size() + 3, 3}));
}

TEST(MessageSplitter, OfAFrameThatNeverEndsFindsTheOneBehindItsStart) {
  auto split = splitter("ubx");
  // A header that announces 200 bytes, then an ACK-ACK for CFG-MSG.
  const std::string cut("\xB5\x62\x01\x07\xC8\x00", 6);
  const std::string ack("\xB5\x62\x05\x01\x02\x00\x06\x01\x0F\x38", 10);
  Pieces pieces;
  split.feed(bytes_of(cut + ack), pieces.taker);
  EXPECT_EQ(pieces.all, "");
  split.finish(pieces.taker);
  EXPECT_EQ(pieces.messages, std::vector{ack});
  EXPECT_EQ(pieces.between, std::vector{cut});
  EXPECT_TRUE(split.empty());
}

TEST(MessageSplitter, ReleasedGivesWhatWaitsAsItIs) {
  auto split = splitter("nmea0183");
  Pieces pieces;
  split.feed(bytes_of("$GPGGA,12"), pieces.taker);
  EXPECT_EQ(pieces.all, "");
  split.release(pieces.taker);
  EXPECT_EQ(pieces.between, std::vector<std::string>{"$GPGGA,12"});
}

TEST(MessageSplitter, LosesNoByteOfAnyInputInAnySplit) {
  EXPECT_TRUE(holds([] {
    const auto protocol = *rc::gen::element<std::string>("nmea0183", "ubx", "pd0", "pd4", "pd6",
                                                         "water-linked", "ubx+nmea0183");
    auto split = splitter(protocol);
    Pieces pieces;
    std::string fed;
    for (int i = *rc::gen::inRange(0, 20); i > 0; --i) {
      const auto noise = *rc::gen::container<std::string>(rc::gen::element<char>(
          '$', '\x7F', '\xB5', '\x62', '\x7D', '*', '\r', '\n', '\0', '1', ':', 'w'));
      const auto chunk = *rc::gen::element(noise, gga, rmc, gga.substr(0, 20));
      split.feed(bytes_of(chunk), pieces.taker);
      fed += chunk;
    }
    RC_ASSERT(fed.starts_with(pieces.all));
    split.finish(pieces.taker);
    RC_ASSERT(pieces.all == fed);
  }));
}

}  // namespace message_splitter_test
