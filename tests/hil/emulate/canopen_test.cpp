#include <gtest/gtest.h>

#include "drivers/wire/canopen/canopen.hpp"
#include "drivers/wire/canopen/canopen_sdo.hpp"
#include "tests/drivers/wire/can_fixture.hpp"
#include "tests/hil/emulate/bench.hpp"

namespace drydock::emulate {
namespace {

namespace canopen = wire::canopen;
using rig_config::DeviceKind;

/// An emulated node 1 after its boot.
struct Booted {
  explicit Booted(const rig_config::DeviceConfig& config)
      : node(make_emulated_device(config, trajectory, 1).value()) {
    sent.run(*node, start);
    sent.frames.clear();
  }
  void hears(const wire::CanFrame& frame) { node->receive(frame, sent.now, sent); }
  wire::CanFrame answer_to(const wire::CanFrame& request) {
    sent.frames.clear();
    hears(request);
    return sent.frames.empty() ? wire::CanFrame{} : sent.frames.front().frame;
  }

  Frozen trajectory{under_way()};
  std::unique_ptr<EmulatedDevice> node;
  Recorder sent;
};

const auto started = canopen::encode(canopen::Nmt{canopen::NmtCommand::start, 0});

TEST(EmulatedCanopenNode, OnSyncItSamplesWhenSyncComesAndAnswersLaterByItsLatency) {
  auto config = device(DeviceKind::imu, "cia404-imu", 100);
  config.sync = true;
  config.emulate.latency_s = 0.002;
  Booted bench(config);
  bench.hears(started);
  bench.sent.run(*bench.node, at_s(0.5));
  EXPECT_TRUE(bench.sent.frames.empty());
  bench.hears(canopen::sync_frame());
  bench.sent.run(*bench.node, at_s(0.9));
  ASSERT_EQ(bench.sent.frames.size(), 3);
  EXPECT_EQ(bench.sent.frames[0].frame.id, 0x181u);
  EXPECT_EQ(bench.sent.frames[0].at, at_s(0.502));
}

// Device type: CiA 404 with analogue inputs, as in object 1000h of real measuring devices.
TEST(EmulatedCanopenNode, AnswersExpeditedReads) {
  Booted bench(device(DeviceKind::imu, "cia404-imu", 100));
  const auto type = bench.answer_to(canopen::encode(canopen::SdoRead{1, {0x1000, 0}}));
  EXPECT_EQ(type.id, 0x581u);
  const auto value = canopen::decode_sdo_response(type);
  ASSERT_TRUE(value);
  EXPECT_EQ(std::get<canopen::SdoValue>(*value).value, 0x00020194u);
  const auto none = bench.answer_to(canopen::encode(canopen::SdoRead{1, {0x2FFF, 0}}));
  EXPECT_EQ(std::get<canopen::SdoAbort>(*canopen::decode_sdo_response(none)).code, 0x06020000u);
  EXPECT_EQ(bench.answer_to(canopen::encode(canopen::SdoRead{2, {0x1000, 0}})), wire::CanFrame{});
}

TEST(EmulatedCanopenNode, ItsHeartbeatTimeCanBeSetAndTheRestNot) {
  Booted bench(device(DeviceKind::imu, "cia404-imu", 100));
  const auto set = bench.answer_to(canopen::encode(canopen::SdoWrite{1, {0x1017, 0}, 250, 2}));
  EXPECT_EQ(set.data[0], 0x60);
  bench.sent.frames.clear();
  bench.sent.run(*bench.node, at_s(1));
  EXPECT_EQ(bench.sent.frames.size(), 4);
  const auto fixed = bench.answer_to(canopen::encode(canopen::SdoWrite{1, {0x1000, 0}, 1, 4}));
  EXPECT_EQ(std::get<canopen::SdoAbort>(*canopen::decode_sdo_response(fixed)).code, 0x06010002u);
}

// CiA 301, 7.3.2: after both resets the values are those of power-on.
TEST(EmulatedCanopenNode, AResetGivesTheHeartbeatItsPowerOnTimeAgain) {
  for (const auto command :
       {canopen::NmtCommand::reset_node, canopen::NmtCommand::reset_communication}) {
    Booted bench(device(DeviceKind::imu, "cia404-imu", 100));
    bench.answer_to(canopen::encode(canopen::SdoWrite{1, {0x1017, 0}, 100, 2}));
    bench.hears(canopen::encode(canopen::Nmt{command, 1}));
    const auto read = bench.answer_to(canopen::encode(canopen::SdoRead{1, {0x1017, 0}}));
    EXPECT_EQ(std::get<canopen::SdoValue>(*canopen::decode_sdo_response(read)).value, 1000u);
    bench.sent.frames.clear();
    bench.sent.run(*bench.node, at_s(3.5));
    EXPECT_EQ(bench.sent.frames.size(), 3) << "one beat a second";
  }
}

// Abort codes of CiA 301, table 22.
TEST(EmulatedCanopenNode, TellsAMissingSubIndexFromAMissingObject) {
  Booted bench(device(DeviceKind::imu, "cia404-imu", 100));
  const auto code = [&](const wire::CanFrame& request) {
    const auto response = canopen::decode_sdo_response(bench.answer_to(request));
    return response ? std::get<canopen::SdoAbort>(*response).code : 0;
  };
  EXPECT_EQ(code(canopen::encode(canopen::SdoRead{1, {0x1018, 9}})), 0x06090011u);
  EXPECT_EQ(code(canopen::encode(canopen::SdoWrite{1, {0x1018, 9}, 1, 4})), 0x06090011u);
  EXPECT_EQ(code(canopen::encode(canopen::SdoRead{1, {0x1A00, 9}})), 0x06090011u);
  EXPECT_EQ(code(canopen::encode(canopen::SdoRead{1, {0x2345, 0}})), 0x06020000u);
}

TEST(EmulatedCanopenNode, AbortsTransfersThatItDoesNotHaveInsteadOfSilence) {
  Booted bench(device(DeviceKind::imu, "cia404-imu", 100));
  const auto answer = [&](std::initializer_list<std::uint8_t> bytes) {
    wire::CanFrame request;
    request.id = 0x601;
    request.size = static_cast<std::uint8_t>(bytes.size());
    std::copy(bytes.begin(), bytes.end(), request.data.begin());
    return wire::test::text_of(bench.answer_to(request));
  };
  EXPECT_EQ(answer({0xA0, 0x00, 0x10, 0, 4, 0, 0, 0}), "581#8000100001000405") << "blocks";
  EXPECT_EQ(answer({0x60, 0, 0, 0, 0, 0, 0, 0}), "581#8000000001000405") << "a next segment";
  EXPECT_EQ(answer({0x00, 1, 2, 3, 4, 5, 6, 7}), "581#8000000001000405") << "a segment";
  EXPECT_EQ(answer({0x40, 0x00, 0x10}), "581#8000100001000405") << "too short";
  bench.sent.frames.clear();
  EXPECT_EQ(answer({0x80, 0, 0x10, 0, 0, 0, 0, 5}), "000#") << "an abort is not answered";
}

}  // namespace
}  // namespace drydock::emulate
