#include <gtest/gtest.h>

#include "drivers/device/order/canopen_orders.hpp"
#include "drivers/device/order/nmea2000_orders.hpp"
#include "tests/drivers/device/support.hpp"

namespace drydock::device::test {
namespace order_sender_test {

using namespace std::chrono_literals;
using measurement::ActuatorOrder;

constexpr ActuatorOrder all{10 * degree, -5 * degree, 2 * degree, 100};

std::vector<Octets> payloads(const Ear& ear, std::uint32_t id) {
  std::vector<Octets> found;
  for (const auto& frame : ear.sent_frames)
    if (frame.id == id) found.emplace_back(frame.payload().begin(), frame.payload().end());
  return found;
}

// Layouts: canboat's PGN database. 10 degrees are 1745 (06D1h) in 1e-4 rad, and to port, so
// negative; 100 rad/s are 3820 (0EECh) quarters of a turn a minute.
TEST(Nmea2000Orders, SendsAnglesAndShaftSpeedFromTheAddressThatItClaimed) {
  Nmea2000Orders orders({true, true, false, true}, 4, 0x20);
  Ear ear;
  orders.restart(at_s(0), ear);
  ASSERT_EQ(ear.sent_frames.size(), 1);
  EXPECT_EQ(ear.sent_frames[0].id, 0x18EEFF20);
  orders.order(all, at_s(0.1), ear);
  EXPECT_EQ(ear.sent_frames.size(), 1) << "nothing before 250 ms without contention";
  ASSERT_TRUE(orders.deadline());
  orders.tick(*orders.deadline(), ear);
  ear.sent_frames.clear();
  orders.order(all, at_s(0.3), ear);
  EXPECT_EQ(payloads(ear, 0x09F10D20),
            (std::vector<Octets>{{0, 0xF8, 0x2F, 0xF9, 0xFF, 0x7F, 0xFF, 0xFF},
                                 {1, 0xF8, 0x97, 0xFC, 0xFF, 0x7F, 0xFF, 0xFF}}));
  EXPECT_EQ(payloads(ear, 0x09F20020),
            (std::vector<Octets>{{4, 0xEC, 0x0E, 0xFF, 0xFF, 0x7F, 0xFF, 0xFF}}));
  EXPECT_EQ(ear.sent_frames.size(), 3) << "the bow planes belong to another sender";
}

/// The master of a drive for the stern planes (node 11), whose silence of 900 ms stops it.
struct Master {
  Master() { orders.restart(at_s(0), ear); }
  void order(double t) {
    ear.sent_frames.clear();
    orders.order(all, at_s(t), ear);
  }
  void hear(std::uint32_t id, const std::vector<std::uint8_t>& bytes) {
    wire::CanFrame frame;
    frame.id = id;
    frame.size = static_cast<std::uint8_t>(bytes.size());
    std::ranges::copy(bytes, frame.data.begin());
    orders.receive(frame, at_s(0), ear);
  }
  void set_up() {
    order(0);
    hear(0x58B, {0x60, 0x60, 0x60, 0, 0, 0, 0, 0});
    order(0.05);
    hear(0x58B, {0x60, 0x16, 0x10, 1, 0, 0, 0, 0});
  }
  Ear ear;
  CanopenOrders orders{{{.node = 11, .actuator = 1, .patience = 900ms}}};
};

// CiA 301: expedited downloads of 1 byte (2Fh) and of 4 bytes (23h); the heartbeat of node 127
// (7Fh) within 900 ms (384h).
TEST(CanopenOrders, SetsTheModeAndTheHeartbeatThatTheDriveWatches) {
  Master master;
  master.order(0);
  EXPECT_EQ(payloads(master.ear, 0x60B), (std::vector<Octets>{{0x2F, 0x60, 0x60, 0, 8, 0, 0, 0}}));
  EXPECT_EQ(payloads(master.ear, 0x77F), (std::vector<Octets>{{5}}));
  master.order(0.1);
  EXPECT_TRUE(payloads(master.ear, 0x60B).empty()) << "it waits for the answer";
  master.order(0.6);
  EXPECT_EQ(payloads(master.ear, 0x60B).size(), 1) << "and then asks again";
  master.hear(0x58B, {0x60, 0x60, 0x60, 0, 0, 0, 0, 0});
  master.order(0.7);
  EXPECT_EQ(payloads(master.ear, 0x60B),
            (std::vector<Octets>{{0x23, 0x16, 0x10, 1, 0x84, 0x03, 0x7F, 0}}));
  EXPECT_TRUE(payloads(master.ear, 0x20B).empty());
}

TEST(CanopenOrders, LeadsTheDriveIntoOperationAndOutOfAFault) {
  Master master;
  master.set_up();
  const auto word_after = [&](std::uint16_t status, double t) {
    master.hear(0x18B, {static_cast<std::uint8_t>(status & 0xFF),
                        static_cast<std::uint8_t>(status >> 8), 0, 0, 0, 0});
    master.order(t);
    const auto sent = payloads(master.ear, 0x20B);
    return sent.empty() ? -1 : sent[0][0];
  };
  EXPECT_EQ(word_after(0x0250, 0.1), 0x06);
  EXPECT_EQ(word_after(0x0231, 0.2), 0x07);
  EXPECT_EQ(word_after(0x0233, 0.3), 0x0F);
  EXPECT_EQ(word_after(0x0237, 0.4), 0x0F);
  EXPECT_EQ(word_after(0x0218, 0.5), 0x80);
  EXPECT_EQ(word_after(0x0218, 0.6), 0x00) << "a reset is a rise of its bit";
  EXPECT_EQ(word_after(0x0218, 0.7), 0x80);
  // -5 degrees of 65536 increments a turn: -910 (FC72h)
  EXPECT_EQ(payloads(master.ear, 0x20B)[0], (Octets{0x80, 0, 0x72, 0xFC, 0xFF, 0xFF}));
}

TEST(CanopenOrders, BeatsThreeTimesInThePatienceAndOnlyWithOrders) {
  Master master;
  int beats = 0;
  for (int i = 0; i < 90; ++i) {
    master.order(0.1 * i);
    beats += static_cast<int>(payloads(master.ear, 0x77F).size());
  }
  EXPECT_EQ(beats, 30);
  EXPECT_FALSE(master.orders.deadline());
}

TEST(CanopenOrders, ADriveThatBootsAnewIsSetUpAnew) {
  Master master;
  master.set_up();
  master.hear(0x70B, {0});
  master.order(1);
  EXPECT_EQ(payloads(master.ear, 0x60B), (std::vector<Octets>{{0x2F, 0x60, 0x60, 0, 8, 0, 0, 0}}));
}

TEST(CanopenOrders, ARefusedSettingIsSaidAndTriedAgain) {
  Master master;
  master.order(0);
  master.hear(0x58B, {0x80, 0x60, 0x60, 0, 0x22, 0, 0, 0x08});
  EXPECT_EQ(master.ear.reports.size(), 1);
  master.order(0.6);
  EXPECT_EQ(payloads(master.ear, 0x60B).size(), 1);
}

}  // namespace order_sender_test
}  // namespace drydock::device::test
