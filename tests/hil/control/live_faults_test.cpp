#include "hil/control/live_faults.hpp"

#include <gmock/gmock.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>

#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/post.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "drivers/link/clock.hpp"
#include "hil/control/orders.hpp"
#include "hil/motion/kinematic_trajectory.hpp"
#include "tests/drivers/link/running.hpp"

namespace drydock::control {
namespace live_faults_test {

using Json = nlohmann::json;
using link::testing::run_until;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using namespace std::chrono_literals;

const auto start = measurement::stamp_from_ns(1'700'000'000'000'000'000);

rig_config::Rig rig() {
  rig_config::Rig rig;
  rig.name = "live-faults-test";
  rig_config::DeviceConfig dvl;
  dvl.name = "dvl";
  dvl.kind = rig_config::DeviceKind::dvl;
  dvl.protocol = "pd0";
  dvl.link = "memory:dvl?baud=115200";
  rig_config::DeviceConfig log = dvl;
  log.name = "log";
  log.kind = rig_config::DeviceKind::emlog;
  log.protocol = "nmea0183";
  log.link = "memory:log?baud=4800";
  rig.devices = {dvl, log};
  return rig;
}

class Orders : public ::testing::Test {
 protected:
  Json obeyed(const std::string& request, std::chrono::nanoseconds after = 10s) {
    return Json::parse(obey(request, rig_, injector_, start, start + after));
  }
  Json set(const std::string& device, const std::string& fault,
           const std::vector<std::string>& pairs = {}, double for_s = 0) {
    return obeyed(order_to_set(fault_table(device, fault, pairs, for_s)));
  }

  rig_config::Rig rig_ = rig();
  motion::KinematicTrajectory trajectory_{rig_config::MissionConfig{}, start};
  fault::Injector injector_{rig_, trajectory_, start};
};

TEST_F(Orders, SetAFaultFromNowOnForAsLongAsTheySay) {
  const auto answer = set("dvl", "garbage", {"bytes=32"}, 5);
  ASSERT_TRUE(answer["ok"]) << answer;
  EXPECT_EQ(answer["lines"][0], "set: dvl: garbage, bytes = 32, for 5 s");
  ASSERT_EQ(answer["faults"].size(), 1u);
  EXPECT_EQ(answer["faults"][0]["device"], "dvl");
  EXPECT_DOUBLE_EQ(answer["faults"][0]["since_s"], 10);
  EXPECT_DOUBLE_EQ(answer["faults"][0]["until_s"], 15);
  EXPECT_EQ(injector_.in_force(start + 14999ms).size(), 1u);
  EXPECT_TRUE(injector_.in_force(start + 15s).empty());
}

TEST_F(Orders, ASecondOfTheSameKindTakesThePlaceOfTheFirst) {
  set("log", "drop", {"probability=0.5"});
  const auto answer = set("log", "drop", {"probability=0.9"});
  ASSERT_EQ(answer["faults"].size(), 1u);
  EXPECT_EQ(answer["faults"][0]["words"], "log: drop, probability = 0.9");
  EXPECT_EQ(answer["faults"][0]["until_s"], nullptr);
}

TEST_F(Orders, TakeFaultsAwayOfAKindOfADeviceOrAll) {
  set("log", "drop");
  set("log", "flip");
  set("dvl", "drop");
  EXPECT_EQ(obeyed(order_to_clear("log", "flip"))["faults"].size(), 2u);
  EXPECT_EQ(obeyed(order_to_clear("log", ""))["faults"].size(), 1u);
  EXPECT_EQ(obeyed(order_to_clear("", ""))["lines"][0], "cleared: 1");
  EXPECT_TRUE(obeyed(order_to_list())["faults"].empty());
}

TEST_F(Orders, ThatCannotBeObeyedSayWhyAndChangeNothing) {
  const auto line_of = [](const Json& answer) {
    EXPECT_FALSE(answer["ok"]);
    return answer["lines"][0].get<std::string>();
  };
  EXPECT_EQ(line_of(set("log", "bottom-lost")),
            "emlog \"log\" (nmea0183) cannot have the fault \"bottom-lost\": only a dvl hears the "
            "sea bed");
  EXPECT_THAT(line_of(set("sonar", "drop")), HasSubstr("no device is named \"sonar\""));
  EXPECT_THAT(line_of(set("log", "gremlins")), HasSubstr("fault: "));
  EXPECT_THAT(line_of(set("log", "drop", {"probability=2"})),
              HasSubstr("out of range, allowed: 0 to 1"));
  EXPECT_THAT(line_of(set("log", "drop", {"bytes=2"})), HasSubstr("allowed: probability"));
  EXPECT_THAT(line_of(obeyed(order_to_clear("log", "gremlins"))), HasSubstr("gremlins"));
  EXPECT_THAT(line_of(obeyed(order_to_clear("sonar", ""))), HasSubstr("sonar"));
  for (const char* nonsense :
       {"", "{", "[]", "7", "{\"do\":\"sink\"}", "{\"do\":7}", "{\"do\":\"set\"}",
        "{\"do\":\"set\",\"fault\":\"[[\"}", "{\"do\":\"set\",\"fault\":\"\"}", "\xFF\xFE"})
    EXPECT_FALSE(obeyed(nonsense)["ok"]) << nonsense;
  EXPECT_TRUE(injector_.in_force(start + 10s).empty());
}

TEST_F(Orders, TypedTextNeverBecomesAnotherTable) {
  EXPECT_THROW(fault_table("dvl", "drop", {"probability"}, 0), std::runtime_error);
  EXPECT_THROW(fault_table("dvl", "drop", {"a]=1"}, 0), std::runtime_error);
  const auto table = fault_table("dvl\"\n[[fault]]", "drop", {"x=1\n[[fault]]"}, 0);
  EXPECT_EQ(table.find("\n[[fault]]"), std::string::npos);
  EXPECT_THAT(fault_table("dvl", "bias", {"velocity_mps=0.5,0,0"}, 0),
              HasSubstr("velocity_mps = [0.5,0,0]\n"));
}

class Socket : public ::testing::Test {
 protected:
  std::unique_ptr<ControlSocket> open() {
    auto opened = ControlSocket::open(io_.get_executor(), path_, [](std::string_view request) {
      return "heard " + std::string(request);
    });
    EXPECT_TRUE(opened) << (opened ? "" : opened.error());
    return opened ? std::move(*opened) : nullptr;
  }
  /// Asks from another thread, as another program does.
  boost::system::result<std::string> ask_it(const std::string& request) {
    boost::system::result<std::string> answer = std::string();
    bool done = false;
    std::thread asking([&] {
      answer = ask(path_, request);
      boost::asio::post(io_, [&] { done = true; });
    });
    EXPECT_TRUE(run_until(io_, [&] { return done; }));
    asking.join();
    return answer;
  }
  void TearDown() override {
    io_.restart();
    io_.run_for(5s);
    EXPECT_TRUE(io_.stopped());
  }

  link::testing::Folder folder_;
  std::string path_ = folder_.file("rig.control");
  boost::asio::io_context io_;
};

TEST_F(Socket, AnswersItsOwnerAloneAndGoesWithItsProgram) {
  auto socket = open();
  struct stat info {};
  ASSERT_EQ(::stat(path_.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600u);
  EXPECT_EQ(*ask_it("ping"), "heard ping");
  EXPECT_EQ(*ask_it("again"), "heard again");
  socket.reset();
  EXPECT_NE(::stat(path_.c_str(), &info), 0);
  EXPECT_FALSE(ask(path_, "ping"));
}

TEST_F(Socket, OfAKilledProgramIsReplacedAndOfALivingOneNot) {
  {
    sockaddr_un left_behind{};
    left_behind.sun_family = AF_UNIX;
    path_.copy(left_behind.sun_path, sizeof left_behind.sun_path - 1);
    const int fd = ::socket(AF_UNIX, SOCK_STREAM, 0);
    ASSERT_EQ(::bind(fd, reinterpret_cast<const sockaddr*>(&left_behind), sizeof left_behind), 0);
    ::close(fd);
  }
  EXPECT_FALSE(ask(path_, "ping"));
  auto socket = open();
  EXPECT_EQ(*ask_it("ping"), "heard ping");
  const auto second =
      ControlSocket::open(io_.get_executor(), path_, [](std::string_view) { return ""; });
  ASSERT_FALSE(second);
  EXPECT_THAT(second.error(), HasSubstr("another program answers at"));
  EXPECT_EQ(*ask_it("still"), "heard still");
  socket.reset();
}

/// The path of a socket has 108 bytes with its closing zero: unix(7).
TEST_F(Socket, OfARigWithALongNameIsFoundByItsHash) {
  ::setenv("XDG_RUNTIME_DIR", folder_.file("").c_str(), 1);
  EXPECT_EQ(std::filesystem::path(control_path("demo")).filename(), "demo.control");
  const std::string name(91, 'n');
  path_ = control_path(name);
  EXPECT_LE(path_.size() + std::string(".4194304.new").size(), 107U);
  EXPECT_NE(path_, control_path(name.substr(1) + "m"));
  auto socket = open();
  ASSERT_TRUE(socket);
  EXPECT_EQ(*ask_it("ping"), "heard ping");
  ::unsetenv("XDG_RUNTIME_DIR");
}

TEST_F(Socket, InAFolderWithALongNameIsRefusedWithALine) {
  ::setenv("XDG_RUNTIME_DIR", folder_.file(std::string(100, 'f')).c_str(), 1);
  const auto path = control_path("demo");
  const auto refused =
      ControlSocket::open(io_.get_executor(), path, [](std::string_view) { return ""; });
  ::unsetenv("XDG_RUNTIME_DIR");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error(),
            path + " is too long for a socket; set XDG_RUNTIME_DIR to a shorter path");
  EXPECT_FALSE(ask(path, "ping"));
}

TEST_F(Socket, IsNotOpenedInAPlantedFolder) {
  const std::string planted = folder_.file("planted");
  std::filesystem::create_directory_symlink(folder_.file(""), planted);
  const auto refused = ControlSocket::open(io_.get_executor(), planted + "/rig.control",
                                           [](std::string_view) { return ""; });
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(), HasSubstr("planted is a symbolic link; remove it"));
}

TEST_F(Socket, IsNotOpenedWhereOthersMayPutNames) {
  ::chmod(std::filesystem::path(path_).parent_path().c_str(), 0777);
  const auto refused =
      ControlSocket::open(io_.get_executor(), path_, [](std::string_view) { return ""; });
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error(), HasSubstr("may be written by others"));
}

TEST_F(Socket, ACallerThatSaysNothingOrTooMuchHoldsNobodyUp) {
  auto socket = open();
  boost::asio::io_context other;
  using Local = boost::asio::local::stream_protocol;
  std::vector<Local::socket> silent;
  for (int i = 0; i < 8; ++i) {
    silent.emplace_back(other);
    silent.back().connect(Local::endpoint(path_));
  }
  EXPECT_FALSE(ask_it(std::string(2 * ControlSocket::longest_line, 'x')));
  EXPECT_EQ(*ask_it("ping"), "heard ping");
  socket.reset();
}

TEST_F(Socket, ThatManyIdleCallersHoldSaysThatItIsBusy) {
  auto socket = open();
  boost::asio::io_context other;
  using Local = boost::asio::local::stream_protocol;
  std::vector<Local::socket> idle;
  for (int i = 0; i < 16; ++i) {
    idle.emplace_back(other);
    idle.back().connect(Local::endpoint(path_));
  }
  const auto answer = ask_it("ping");
  ASSERT_TRUE(answer) << answer.error().message();
  EXPECT_THAT(*answer, HasSubstr("the bench runs"));
  socket.reset();
}

TEST(LiveFaults, SetByHandEndByThemselvesAndAreToldOnceEach) {
  const link::testing::Folder folder;
  ::setenv("XDG_RUNTIME_DIR", folder.file("").c_str(), 1);
  boost::asio::io_context io;
  const auto bench = rig();
  const motion::KinematicTrajectory trajectory{rig_config::MissionConfig{}, link::steady_now()};
  LiveFaults faults(io, bench, trajectory, trajectory.start());
  std::vector<std::string> lines;
  std::vector<bool> ended;
  int wakes = 0;
  faults.set_on_change([&](const fault::Episode& e) { ended.push_back(e.until.has_value()); });
  faults.start([&] { ++wakes; }, [&](const std::string& line) { lines.push_back(line); });
  EXPECT_TRUE(Json::parse(faults.answer(order_to_set(fault_table("dvl", "drop", {}, 0.2))))["ok"]);
  EXPECT_EQ(wakes, 1);
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_THAT(lines[0], HasSubstr(" s fault set: dvl: drop, probability = 0.2"));
  ASSERT_TRUE(run_until(io, [&] { return lines.size() == 2; }));
  EXPECT_THAT(lines[1], HasSubstr(" s fault cleared: dvl: drop"));
  faults.answer(order_to_set(fault_table("log", "hang", {}, 0)));
  faults.answer(order_to_clear("log", "hang"));
  EXPECT_EQ(lines.size(), 4u);
  EXPECT_THAT(ended, ElementsAre(false, true, false, true));
  faults.stop();

  summary::Summary summary;
  faults.write(summary);
  ASSERT_EQ(summary.faults.size(), 2u);
  EXPECT_NEAR(*summary.faults[0].until_s - summary.faults[0].since_s, 0.2, 1e-6);
  io.restart();
  io.run_for(5s);
  EXPECT_TRUE(io.stopped());
}

}  // namespace live_faults_test
}  // namespace drydock::control
