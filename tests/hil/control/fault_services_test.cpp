#include "hil/control/fault_services.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "hil/control/orders.hpp"
#include "hil/control/request/fault_requests.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::control {
namespace fault_services_test {

using nlohmann::json;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

const auto start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

rig_config::DeviceConfig device(const char* name, rig_config::DeviceKind kind, const char* protocol,
                                const char* link) {
  rig_config::DeviceConfig device;
  device.name = name;
  device.kind = kind;
  device.protocol = protocol;
  device.link = link;
  return device;
}

rig_config::Rig rig() {
  rig_config::Rig rig;
  rig.name = "fault-services-test";
  using enum measurement::Kind;
  rig.devices = {device("dvl", dvl, "pd0", "pty:dvl?baud=115200"),
                 device("imu", imu, "cia404-imu", "memory-can:bus?bitrate=250000"),
                 device("gnss", gnss, "ubx", "serial:/dev/ttyUSB0?baud=38400")};
  return rig;
}

/// A bench whose services the test calls as a viewer does.
class FaultServices : public ::testing::Test {
 protected:
  std::string ordered(const std::string& order) {
    return obey(order, rig_, injector_, start, start + 10s);
  }

  live::ServiceAnswer call(const std::string& name, const std::string& request) {
    live::ServiceAnswer got;
    for (const auto& service : services_)
      if (service.name == "/drydock/faults/" + name)
        service.serve(request, [&](const live::ServiceAnswer& answer) { got = answer; });
    return got;
  }
  json done(const std::string& name, const json& request) {
    const auto answer = call(name, request.dump());
    const auto* good = std::get_if<std::string>(&answer);
    EXPECT_NE(good, nullptr) << request << std::get<live::Refused>(answer).why;
    return good ? json::parse(*good) : json();
  }
  std::string why(const std::string& name, const json& request) {
    const auto answer =
        call(name, request.is_string() ? request.get<std::string>() : request.dump());
    return std::get<live::Refused>(answer).why;
  }

  rig_config::Rig rig_ = rig();
  motion::KinematicTrajectory trajectory_{rig_config::MissionConfig{}, start};
  fault::Injector injector_{rig_, trajectory_, start};
  std::vector<live::Service> services_ = fault_services(
      rig_, [this](const std::string& order, const auto& answered) { answered(ordered(order)); });
};

TEST_F(FaultServices, SetListAndClearAsTheCommandLineDoes) {
  const auto answer =
      done("set", {{"device", "dvl"}, {"fault", "garbage"}, {"with", {"bytes=32"}}, {"for", "5s"}});
  EXPECT_EQ(answer["lines"][0], "set: dvl: garbage, bytes = 32, for 5 s");
  EXPECT_EQ(answer["faults"][0]["fault"], "garbage");
  EXPECT_DOUBLE_EQ(answer["faults"][0]["since_s"], 10);
  EXPECT_DOUBLE_EQ(answer["faults"][0]["until_s"], 15);
  EXPECT_DOUBLE_EQ(answer["now_s"], 10);
  EXPECT_EQ(done("list", json::object())["faults"], answer["faults"]);
  EXPECT_EQ(done("clear", {{"device", "dvl"}, {"fault", "garbage"}})["lines"][0], "cleared: 1");
  EXPECT_TRUE(injector_.in_force(start + 10s).empty());
}

TEST_F(FaultServices, RefuseInTheWordsThatTheCommandLineHas) {
  const auto typed = [&](const char* fault, const std::vector<std::string>& pairs) {
    return json::parse(ordered(order_to_set(fault_table("dvl", fault, pairs, 0))))["lines"][0];
  };
  EXPECT_EQ(why("set", {{"device", "dvl"}, {"fault", "bus-off"}}), typed("bus-off", {}));
  EXPECT_EQ(why("set", {{"device", "dvl"}, {"fault", "drop"}, {"with", {"probability=2"}}}),
            typed("drop", {"probability=2"}));
  EXPECT_EQ(why("set", {{"device", "dvl"}, {"fault", "bias"}}), typed("bias", {}));
  EXPECT_EQ(why("set", {{"device", "dvl"}, {"fault", "gremlins"}}), typed("gremlins", {}));
  EXPECT_THAT(why("set", {{"device", "gnss"}, {"fault", "hang"}}), HasSubstr("is not emulated"));
  EXPECT_THAT(why("clear", {{"device", "sonar"}}), HasSubstr("no device is named \"sonar\""));
  EXPECT_EQ(why("set", {{"device", "dvl"}, {"fault", "hang"}, {"for", "soon"}}),
            "'soon' is no duration; allowed: 90, 60s, 10min, 5.5h");
  EXPECT_THAT(why("set", {{"device", "dvl"}, {"fault", "drop"}, {"with", {"probability"}}}),
              HasSubstr("is no KEY=VALUE"));
  EXPECT_TRUE(injector_.in_force(start + 10s).empty());
}

TEST_F(FaultServices, RefuseWhatIsNoRequestAndWhatIsTooLong) {
  for (const char* nonsense : {"", "{", "[]", "7", "\xff", R"({"device":7,"fault":"hang"})",
                               R"({"device":"dvl","fault":"hang","with":"x"})",
                               R"({"device":"dvl","fault":"hang","with":[7]})",
                               R"({"device":"dvl","fault":"hang","sink":true})"})
    EXPECT_FALSE(why("set", nonsense).empty()) << nonsense;
  const std::string deep = std::string(30'000, '[') + std::string(30'000, ']');
  EXPECT_FALSE(why("clear", R"({"device":)" + deep + "}").empty());
  EXPECT_LT(why("clear", {{std::string(60'000, 'k'), ""}}).size(), 300U);
  EXPECT_THAT(why("set", {{"device", std::string(201, 'x')}, {"fault", "hang"}}),
              HasSubstr("at most 200 bytes"));
  EXPECT_THAT(why("set", {{"device", "dvl"}, {"fault", "drop"}, {"with", json(11, "seed=1")}}),
              HasSubstr("at most 10"));
  EXPECT_TRUE(injector_.in_force(start + 10s).empty());
}

/// Uses the usual amounts, and a fixed number where there is none.
json set_request(const std::string& name, const json& word) {
  json request{{"device", name}, {"fault", word["fault"]}, {"with", json::array()}};
  for (const char* part : {"amounts", "more"}) {
    if (word[part].empty()) continue;
    const json& key = word[part][0];
    const double number = key["usual"].is_null() ? 1200 : key["usual"].get<double>();
    request["with"].push_back(fmt::format("{}={}", key["key"].get<std::string>(), number));
  }
  return request;
}

TEST_F(FaultServices, OfferTheWordsThatCanBeSetAndNoOthers) {
  const json words = done("words", json::object());
  EXPECT_FALSE(words.contains("gnss"));  // a real device
  for (const char* name : {"dvl", "imu"}) {
    std::set<std::string> offered;
    for (const json& word : words[name]) {
      offered.insert(word["fault"]);
      done("set", set_request(name, word));
    }
    for (const auto& word : rig_config::fault_vocabulary()) {
      if (offered.contains(std::string(word.name))) continue;
      json with = json::array();  // all required keys, so that only the device is a reason to
                                  // refuse
      if (std::isnan(word.usual)) with.push_back(fmt::format("{}=1200", word.amount));
      EXPECT_THAT(why("set", {{"device", name}, {"fault", word.name}, {"with", with}}),
                  HasSubstr("cannot have the fault"))
          << word.name;
    }
  }
}

TEST_F(FaultServices, OfARigWithoutEmulatedDevicesAreRefusedInOneLine) {
  rig_.file = "pier.toml";
  rig_.devices = {rig_.devices.back()};
  try {
    fault_services(rig_, {});
    FAIL();
  } catch (const std::runtime_error& refused) {
    EXPECT_STREQ(refused.what(),
                 "--allow-faults: no device of pier.toml is emulated, so none can be given a "
                 "fault; between a real one and its drivers: drydock proxy");
  }
}

}  // namespace fault_services_test
}  // namespace drydock::control
