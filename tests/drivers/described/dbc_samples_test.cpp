#include <map>

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/j1939/j1939.hpp"
#include "tests/drivers/described/dbc_folder.hpp"

/// Which frames make a sample, and which frames an emulated sensor sends.
namespace drydock::described::test {
namespace dbc_samples_test {

using measurement::DepthSample;
using measurement::ImuSample;

class DbcSamples : public DbcFolder {
 protected:
  DescriptionPtr imu() const {
    return description("imu", R"(BO_ 256 gyro: 6 s
 SG_ gx : 0|16@1- (0.01,0) [0|0] "deg/s" V
 SG_ gy : 16|16@1- (0.01,0) [0|0] "deg/s" V
 SG_ gz : 32|16@1- (0.01,0) [0|0] "deg/s" V
BO_ 257 acc: 6 s
 SG_ ax : 0|16@1- (0.01,0) [0|0] "m/s2" V
 SG_ ay : 16|16@1- (0.01,0) [0|0] "m/s2" V
 SG_ az : 32|16@1- (0.01,0) [0|0] "m/s2" V
)",
                       R"([[protocol.frames]]
message = "gyro"
fields = [
 { signal = "gx", field = "rate_x_degps" },
 { signal = "gy", field = "rate_y_degps" },
 { signal = "gz", field = "rate_z_degps" },
]
[[protocol.frames]]
message = "acc"
fields = [
 { signal = "ax", field = "force_x_mps2" },
 { signal = "ay", field = "force_y_mps2" },
 { signal = "az", field = "force_z_mps2" },
]
)");
  }

  /// A pressure, and a temperature that is optional.
  DescriptionPtr depth() const {
    return description("depth", R"(BO_ 256 P: 4 s
 SG_ press : 0|32@1+ (1,0) [0|0] "Pa" V
BO_ 257 T: 4 s
 SG_ temp : 0|32@1+ (0.01,0) [0|0] "K" V
)",
                       R"([[protocol.frames]]
message = "P"
fields = [{ signal = "press", field = "pressure_pa" }]
[[protocol.frames]]
message = "T"
optional = true
fields = [{ signal = "temp", field = "temperature_k" }]
)");
  }
};

wire::CanFrame words(std::uint32_t id, std::initializer_list<int> values) {
  wire::CanFrame one;
  one.id = id;
  for (const int value : values) {
    wire::store_le<std::int16_t>(one.data, one.size, static_cast<std::int16_t>(value));
    one.size = static_cast<std::uint8_t>(one.size + 2);
  }
  return one;
}

wire::CanFrame long_word(std::uint32_t id, std::uint32_t value) {
  wire::CanFrame one;
  one.id = id;
  one.size = 4;
  wire::store_le<std::uint32_t>(one.data, 0, value);
  return one;
}

/// Sample i says i: rates in 0.01 deg/s, forces in 0.01 m/s2.
long rate_of(const ImuSample& one) {
  return std::lround(one.angular_rate.x() / emulate::degree * 100);
}
long force_of(const ImuSample& one) { return std::lround(one.specific_force.x() * 100); }

TEST_F(DbcSamples, AtOneKilohertzALostFrameCostsItsSampleAndNoOther) {
  for (const bool gyro_is_lost : {true, false}) {
    Bus bus(imu());
    for (int i = 0; i < 40; ++i) {
      const double at_s = 1 + i * 0.001;
      if (i != 10 || !gyro_is_lost) bus.says(words(256, {i, 0, 0}), at_s);
      if (i != 10 || gyro_is_lost) bus.says(words(257, {i, 0, 981}), at_s + 0.0003);
    }
    EXPECT_EQ(bus.all.size(), 39u);
    EXPECT_EQ(bus.refusals.size(), 1u);
    for (const auto& one : bus.all)
      EXPECT_EQ(rate_of(std::get<ImuSample>(one)), force_of(std::get<ImuSample>(one)));
  }
}

TEST_F(DbcSamples, AListenerThatBeginsAmidASampleFindsItsBeginningWithinAFewSamples) {
  Bus bus(imu());
  for (int i = 0; i < 40; ++i) {
    if (i > 0) bus.says(words(256, {i, 0, 0}), 1 + i * 0.001);
    bus.says(words(257, {i, 0, 981}), 1.0003 + i * 0.001);
  }
  ASSERT_GE(bus.all.size(), 38u);
  for (std::size_t i = 5; i < bus.all.size(); ++i)
    EXPECT_EQ(rate_of(std::get<ImuSample>(bus.all[i])), force_of(std::get<ImuSample>(bus.all[i])));
}

TEST_F(DbcSamples, APauseOfTheSensorAmidASampleDoesNotTurnTheOrder) {
  Bus bus(imu());
  double at_s = 1;
  for (int i = 0; i < 40; ++i, at_s += 0.001) {
    bus.says(words(256, {i, 0, 0}), at_s);
    if (i == 20) at_s += 3600;
    bus.says(words(257, {i, 0, 981}), at_s + 0.0003);
  }
  EXPECT_EQ(bus.all.size(), 39u);
  EXPECT_LE(bus.refusals.size(), 2u) << "both halves of the sample that was interrupted";
}

TEST_F(DbcSamples, FramesAtEqualDistancesAreJoinedAsTheyCome) {
  Bus bus(imu());
  for (int i = 0; i < 40; ++i) {
    bus.says(words(256, {i, 0, 0}), 1 + i * 0.005);
    bus.says(words(257, {i, 0, 981}), 1.0025 + i * 0.005);
  }
  EXPECT_EQ(bus.all.size(), 40u);
  EXPECT_TRUE(bus.refusals.empty());
}

TEST_F(DbcSamples, AnOptionalMessageBehindASampleBelongsToTheNext) {
  Bus bus(depth());
  for (int i = 0; i < 100; ++i) {
    bus.says(long_word(256, 200'000u + static_cast<unsigned>(i)), 1 + i * 0.05);
    bus.says(long_word(257, 28'000u + static_cast<unsigned>(i)), 1.0004 + i * 0.05);
  }
  ASSERT_EQ(bus.all.size(), 100u);
  EXPECT_TRUE(bus.refusals.empty());
  EXPECT_FALSE(std::get<DepthSample>(bus.all[0]).temperature_k);
  for (std::size_t i = 1; i < 100; ++i) {
    const auto& sample = std::get<DepthSample>(bus.all[i]);
    EXPECT_NEAR(*sample.temperature_k, 280 + 0.01 * static_cast<double>(i - 1), 1e-9);
    EXPECT_NEAR(*sample.pressure_pa, 200'000.0 + static_cast<double>(i), 1e-9);
    EXPECT_LE(sample.origin.valid_at, Stamp{measurement::from_seconds(1 + 0.05 * double(i))});
    EXPECT_GT(sample.origin.valid_at,
              Stamp{measurement::from_seconds(1 + 0.05 * double(i) - 0.001)});
  }
}

TEST_F(DbcSamples, AnOptionalValueThatNoSampleFollowedForTenSecondsIsForgotten) {
  Bus bus(depth());
  bus.says(long_word(257, 28'000), 1);
  bus.says(long_word(256, 200'000), 11.1);
  ASSERT_EQ(bus.all.size(), 1u);
  EXPECT_FALSE(bus.last<DepthSample>().temperature_k);
}

/// How often each identifier comes from the emulated sensor.
std::map<std::uint32_t, int> frames_of(const DescriptionPtr& description, double rate_hz,
                                       double seconds) {
  const emulate::Frozen truth(emulate::under_way());
  auto config = emulate::device(description->kind.value(), description->name, rate_hz);
  config.description = description;
  std::map<std::uint32_t, int> count;
  emulate::EmulatedBus line(500'000, [&](const wire::CanFrame& one, std::size_t,
                                         const emulate::Passage&) { ++count[one.id]; });
  line.add(emulate::make_emulated_device(config, truth, 1).value());
  shell::Lockstep lockstep(emulate::start);
  lockstep.add(line);
  lockstep.run_until(emulate::at_s(seconds));
  return count;
}

TEST_F(DbcSamples, AMessageOfConstantsIsSentAtItsCycleTimeAndOneOfNamesIsNot) {
  const std::string dbc = R"(BO_ 256 P: 4 s
 SG_ press : 0|32@1+ (1,0) [0|0] "Pa" V
BO_ 257 state: 2 s
 SG_ serial : 0|16@1+ (1,0) [0|0] "" V
BO_ 258 other: 2 s
 SG_ word : 0|16@1+ (1,0) [0|0] "" V
BA_DEF_ BO_ "GenMsgCycleTime" INT 0 65535;
BA_DEF_DEF_ "GenMsgCycleTime" 0;
BA_ "GenMsgCycleTime" BO_ 256 20;
BA_ "GenMsgCycleTime" BO_ 257 250;
)";
  const auto made = description("depth", dbc, R"([[protocol.frames]]
message = "P"
fields = [{ signal = "press", field = "pressure_pa" }]
[[protocol.frames]]
message = "state"
sample = "slow"
fields = [{ signal = "serial", name = "serial", emulate = 4660 }]
[[protocol.frames]]
message = "other"
sample = "slow"
fields = [{ signal = "word", name = "word" }]
)");
  const auto count = frames_of(made, 50, 49.99);
  EXPECT_NEAR(count.at(256), 2500, 1);
  EXPECT_NEAR(count.at(257), 200, 1) << "250 ms, which is no multiple of 20 ms";
  EXPECT_FALSE(count.contains(258));
}

TEST_F(DbcSamples, ACounterOfAutosarsProfile1CountsTo14) {
  for (const char* kind : {"e2e-1-both", "e2e-1-alternating", "e2e-1-low"}) {
    const auto made = description("depth", R"(BO_ 256 P: 6 s
 SG_ crc : 0|8@1+ (1,0) [0|0] "" V
 SG_ cnt : 11|4@0+ (1,0) [0|0] "" V
 SG_ press : 16|32@1+ (1,0) [0|0] "Pa" V
)",
                                  std::string("[[protocol.frames]]\nmessage = \"P\"\n") +
                                      "counter = { signal = \"cnt\" }\nchecksum = { signal = "
                                      "\"crc\", data_id = 291, kind = \"" +
                                      kind +
                                      "\" }\nfields = [{ signal = \"press\", field = "
                                      "\"pressure_pa\" }]\n");
    Bus bus(made);
    run(made, 50, 6, bus);
    EXPECT_NEAR(static_cast<double>(bus.all.size()), 300, 2) << kind;
    EXPECT_EQ(bus.driver->counters().bad_checksums, 0u) << kind;
    EXPECT_TRUE(bus.reports.empty()) << kind;
  }
}

/// PGN 65280 of any sender: a pressure, signed or not.
std::string proprietary(const std::string& sign) {
  return "BO_ 2566848766 P: 8 s\n SG_ press : 0|32@1" + sign + R"( (1,0) [0|0] "Pa" V
BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","ExtendedCAN","reserved","J1939PG";
BA_DEF_DEF_ "VFrameFormat" "StandardCAN";
BA_ "VFrameFormat" BO_ 2566848766 3;
)";
}

constexpr const char* pressure = R"([[protocol.frames]]
message = "P"
fields = [{ signal = "press", field = "pressure_pa" }]
)";

TEST_F(DbcSamples, OnlyUnsignedSignalsOfJ1939SayThatTheyHaveNoValue) {
  const auto depth_after = [&](const std::string& sign, const char* no_value) {
    Bus bus(description("depth", proprietary(sign),
                        "[[protocol.frames]]\nmessage = \"P\"\nfields = [{ signal = \"press\", "
                        "field = \"depth_m\", unit = \"mm\"" +
                            std::string(no_value) + " }]\n"));
    bus.says(frame("18FF0023#FFFFFFFFFFFFFFFF"), 1);
    const bool told = !bus.all.empty();
    return told ? bus.last<DepthSample>().depth_m : std::nullopt;
  };
  const auto as_signed = depth_after("-", "");
  ASSERT_TRUE(as_signed);
  EXPECT_NEAR(*as_signed, -0.001, 1e-12);
  EXPECT_FALSE(depth_after("-", ", no_value = [-1]"));
  EXPECT_FALSE(depth_after("+", ""));
}

TEST_F(DbcSamples, ASensorWithoutAnAddressIsFollowedByTheNameThatItClaimedBeforeItSpoke) {
  Bus bus(description("depth", proprietary("+"), pressure));
  const auto claims = [&](std::uint8_t source, std::uint64_t name, double at_s) {
    bus.says(wire::j1939::encode(wire::j1939::AddressClaimed{.source = source, .name = name}),
             at_s);
  };
  claims(0x23, 5, 1);
  bus.says(frame("18FF0023#400D0300FFFFFFFF"), 1.3);  // 200000 Pa
  claims(0x32, 5, 2);
  claims(0x23, 2, 2.1);
  bus.says(frame("18FF0023#E0930400FFFFFFFF"), 2.2);  // another unit: 300000 Pa
  bus.says(frame("18FF0032#400D0300FFFFFFFF"), 2.3);
  ASSERT_EQ(bus.all.size(), 2u);
  for (const auto& one : bus.all) EXPECT_EQ(std::get<DepthSample>(one).pressure_pa, 200'000);
}

}  // namespace dbc_samples_test
}  // namespace drydock::described::test
