#include "tests/drivers/wire/dbc_reader.hpp"

#include <gtest/gtest.h>

#include <map>

#include "drivers/wire/registry.hpp"
#include "tests/drivers/property.hpp"
#include "tests/drivers/wire/can_fixture.hpp"

/// Our DBC files, with which other tools open our bus, agree with our codecs.
namespace drydock::wire {
namespace dbc_test {

using test::Dbc;
using test::DbcMessage;
using test::DbcReader;
using test::DbcSignal;

Dbc dbc(const std::string& name) {
  return DbcReader::read(DRYDOCK_SOURCE_DIR "/rig_config/dbc/" + name + ".dbc");
}

/// A message of several frames appears as type_1, type_2, ...
bool is_of(const DbcMessage& message, const std::string& type) {
  return std::regex_match(message.name, std::regex(type + "(_[0-9])?"));
}

/// Finds the message of that type with the frame's identifier: for J1939 by PGN, for CANopen by
/// function code.
const DbcMessage* find(const Dbc& dbc, const std::string& type, const CanFrame& frame) {
  for (const DbcMessage& m : dbc) {
    if (!is_of(m, type) || m.extended != frame.extended) continue;
    const auto pgn = [](std::uint32_t id) { return j1939::parse_identifier(id).pgn; };
    const bool same = frame.extended ? pgn(m.id) == pgn(frame.id) : m.id >> 7 == frame.id >> 7;
    if (same) return &m;
  }
  return nullptr;
}

/// Compares every signal with the JSON key of the same name.
void expect_same(const DbcMessage& message, const CanFrame& frame, const nlohmann::json& json) {
  for (const auto& [name, signal] : message.signals) {
    if (!json.contains(name) || json[name].is_null()) continue;
    if (json[name].is_string()) {
      const auto text = signal.names.find(static_cast<std::int64_t>(signal.raw(frame.payload())));
      ASSERT_NE(text, signal.names.end()) << message.name << " " << name;
      EXPECT_EQ(text->second, json[name]) << message.name << " " << name;
      continue;
    }
    const double number =
        json[name].is_boolean() ? json[name].get<bool>() : json[name].get<double>();
    EXPECT_NEAR(signal.physical(frame.payload()), number, 1e-9 * std::max(1.0, std::abs(number)))
        << message.name << " " << name;
  }
}

/// Decodes the frame with a new decoder of P and compares the message with the reading by the file.
template <class P>
unsigned compare(const Dbc& file, const CanFrame& frame) {
  const auto messages = test::decode_all<P>({frame});
  if (messages.empty()) return 0;
  const auto json = test::to_json(messages.front());
  const DbcMessage* message = find(file, json["type"], frame);
  EXPECT_NE(message, nullptr) << json["type"];
  if (!message || frame.size < message->size) return 0;  // another form of the message
  expect_same(*message, frame, json);
  return 1;
}

/// Compares messages of several frames, type_1, type_2, ..., with the latest frame of each.
template <class P>
unsigned compare_sets(const Dbc& file, const std::vector<CanFrame>& frames) {
  typename P::Decoder decoder;
  std::map<std::uint32_t, CanFrame> latest;
  unsigned compared = 0;
  for (const CanFrame& frame : frames) {
    latest[frame.id] = frame;
    const auto message = decoder.receive(frame);
    if (!message) continue;
    const auto json = test::to_json(*message);
    for (const auto& [id, part] : latest) {
      const DbcMessage* m = find(file, json["type"], part);
      if (!m || m->name == json["type"] || part.size < m->size) continue;
      expect_same(*m, part, json);
      ++compared;
    }
  }
  return compared;
}

template <class P>
struct TypesOf;
template <class... M>
struct TypesOf<std::variant<M...>> {
  static std::vector<std::string> names() { return {std::string(M::type)...}; }
};

template <class P>
class DbcFile : public ::testing::Test {};
template <class List>
struct Tested;
template <class... P>
struct Tested<ProtocolList<P...>> {
  using Types = ::testing::Types<P...>;
};
TYPED_TEST_SUITE(DbcFile, Tested<FrameProtocols>::Types);

TYPED_TEST(DbcFile, HoldsEveryMessageOfTheProtocol) {
  const Dbc file = dbc(std::string(TypeParam::name));
  for (const auto& type : TypesOf<typename TypeParam::Message>::names()) {
    EXPECT_TRUE(
        std::any_of(file.begin(), file.end(), [&](const DbcMessage& m) { return is_of(m, type); }))
        << type << " is not in rig_config/dbc/" << TypeParam::name << ".dbc";
  }
}

TYPED_TEST(DbcFile, ReadsTheGoldenFramesAsTheCodecDoes) {
  const Dbc file = dbc(std::string(TypeParam::name));
  const auto folder = std::string(TypeParam::name);
  unsigned compared = 0;
  for (const auto& frame : test::frames_of_log(test::fixture(folder + "/frames.log"))) {
    compared += compare<TypeParam>(file, frame);
  }
  compared +=
      compare_sets<TypeParam>(file, test::frames_of_log(test::fixture(folder + "/frames.log")));
  EXPECT_GT(compared, 1u);
}

template <class P, class M>
void expect_encoded_alike(const M& message) {
  static const Dbc file = dbc(std::string(P::name));
  const CanFrame frame = encode(message);
  const auto json = test::to_json(std::variant<M>{message});
  const DbcMessage* found = find(file, json["type"], frame);
  ASSERT_NE(found, nullptr) << json["type"];
  EXPECT_EQ(found->size, frame.size);
  for (const auto& [name, signal] : found->signals) {
    if (!json.contains(name) || !json[name].is_number_float()) continue;
    const double number = json[name];
    EXPECT_NEAR(signal.physical(frame.payload()), number, 0.5001 * std::abs(signal.factor))
        << found->name << " " << name;
  }
}

double within(double lowest, double highest) {
  return lowest + (highest - lowest) * *rc::gen::inRange(0, 1'000'001) / 1e6;
}

TEST(Dbc, ReadsWhatTheEncodersWriteToHalfAStep) {
  EXPECT_TRUE(holds([] {
    expect_encoded_alike<Nmea2000>(nmea2000::Pressure{1, 2, 3, 1, within(-2e8, 2e8)});
    expect_encoded_alike<Nmea2000>(
        nmea2000::Temperature{1, 2, 3, 0, within(0, 655), within(0, 655)});
    expect_encoded_alike<Nmea2000>(
        nmea2000::WaterDepth{1, 2, within(0, 4e7), within(-32, 32), within(0, 2500)});
    expect_encoded_alike<Nmea2000>(nmea2000::Rudder{1, 2, 1, within(-3, 3), within(-3, 3)});
    expect_encoded_alike<Nmea2000>(
        nmea2000::Engine{1, 2, within(0, 1700), within(0, 6e6), within(-100, 100)});
    aceinna::AngularRate rate;
    aceinna::Acceleration acceleration;
    for (unsigned axis = 0; axis < 3; ++axis) {
      rate.rate_radps[axis] = within(-4, 4);
      acceleration.acceleration_mps2[axis] = within(-300, 300);
    }
    rate.latency_s = within(0, 0.125);
    expect_encoded_alike<Aceinna>(rate);
    expect_encoded_alike<Aceinna>(acceleration);
    aceinna::SlopeSensor slope;
    slope.pitch_rad = within(-1.5, 1.5);
    slope.roll_rad = within(-3, 3);
    slope.latency_s = within(0, 0.125);
    expect_encoded_alike<Aceinna>(slope);
  }));
}

}  // namespace dbc_test
}  // namespace drydock::wire
