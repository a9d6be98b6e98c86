#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <thread>

#include "drivers/bus/cdr_publisher.hpp"
#include "drivers/live/live_topics.hpp"
#include "drivers/live/page_files.hpp"
#include "tests/npm/node.hpp"

/// The page in headless Chromium, on a bench that is made up here.
namespace drydock::live {
namespace page_test {

namespace asio = boost::asio;
using namespace measurement;
using std::chrono::milliseconds;

struct Look {
  int width;
  const char* theme;
};

/// One of every kind of sensor and an estimator, 20 times a second from a start in the past.
class MadeUpBench {
 public:
  explicit MadeUpBench(Server& server)
      : topics_(server),
        publisher_(topics_,
                   {{"dvl", bus::Kind::dvl},
                    {"log", bus::Kind::emlog},
                    {"gps", bus::Kind::gnss},
                    {"imu", bus::Kind::imu},
                    {"depth", bus::Kind::depth}},
                   {"leveling", "truth"}, {"leveling", "truth"}) {}

  void step() {
    const double t = 0.05 * ++steps_, wave = std::sin(t);
    const auto origin = [&](std::uint16_t device) {
      Origin at;
      at.device = device;
      at.valid_at = at.received_at = start_ + from_seconds(t);
      return at;
    };
    BottomVelocity dvl;
    dvl.origin = origin(0);
    dvl.velocity = Eigen::Vector3d{1.5 + 0.2 * wave, 0.1, 0};
    publisher_.publish(dvl);
    publisher_.publish(WaterSpeed{origin(1), 1.4, {}, {}});
    GnssFix fix;
    fix.origin = origin(2);
    fix.position = Geodetic{0.6 + 1e-6 * t, 0.2 + 1e-6 * wave};
    publisher_.publish(fix);
    GnssSatellites sky;
    sky.origin = origin(2);
    sky.satellites.push_back({Constellation::gps, 7, 44.0, 0.9, 1.0, true});
    publisher_.publish(sky);
    publisher_.publish(ImuSample{origin(3), {0.1 * wave, 0, -9.8}, {0, 0.02 * wave, 0}});
    publisher_.publish(DepthSample{origin(4), 5 + wave, {}, {}, {}});
    publish_estimates(origin(3).valid_at, wave);
    if (steps_ % 10 == 0) publisher_.publish(health_, origin(0).valid_at);
  }

 private:
  /// The estimate is 2 m north of the truth, and knows it to 1 m.
  void publish_estimates(Stamp at, double wave) {
    publisher_.publish(bus::Attitude{at, 0.11 * wave, 0.05, {}, {}}, 1);
    publisher_.publish(bus::Attitude{at, 0.1 * wave, 0.05, {}, attitude_covariance}, 0);
    bus::Navigation where;
    where.valid_at = at;
    where.latitude_rad = 0.6;
    where.longitude_rad = 0.2 + 1e-6 * wave;
    where.height_m = -5;
    publisher_.publish(where, 1);
    where.latitude_rad += 2 / 6.37e6;
    where.velocity_ned.x() = 0.1;
    where.covariance.setIdentity();
    publisher_.publish(where, 0);
  }

  const Stamp start_ = stamp_from_ns(1'700'000'000'000'000'000);
  const Eigen::Matrix2d attitude_covariance = 1e-4 * Eigen::Matrix2d::Identity();
  const std::vector<bus::DeviceStatus> health_{
      {bus::Level::ok, "imu", "100 samples a second", "", {{"state", "streaming"}}},
      {bus::Level::warn, "dvl", "no bottom lock for 3 s", "", {{"state", "degraded"}}}};
  LiveTopics topics_;
  bus::CdrPublisher publisher_;
  int steps_ = 0;
};

class LivePage : public testing::TestWithParam<Look> {
 protected:
  void SetUp() override {
    DRYDOCK_NEEDS_NODE();
    if (std::system("command -v chromium >/dev/null") != 0) {
      ASSERT_EQ(std::getenv("CI"), nullptr) << "chromium is missing";
      GTEST_SKIP() << "chromium is not installed";
    }
    ASSERT_FALSE(server_.listen());
  }

  void keep_stepping() {
    timer_.expires_after(milliseconds{50});
    timer_.async_wait([this](const boost::system::error_code& error) {
      if (error || stopped_) return;  // an expired timer can no longer be cancelled
      bench_.step();
      keep_stepping();
    });
  }

  nlohmann::json look(const Look& how) {
    keep_stepping();
    const auto folder = std::filesystem::path(DRYDOCK_SOURCE_DIR) / "build/screenshots";
    std::filesystem::create_directories(folder);
    nlohmann::json seen;
    std::jthread browser([&] {
      seen = drydock::test::run_node(
          "tests/drivers/live/page.cjs",
          {"/usr/bin/chromium", "http://127.0.0.1:" + std::to_string(server_.port()) + "/",
           folder.string(), std::to_string(how.width), how.theme});
      asio::post(io_, [&] {
        stopped_ = true;
        server_.stop();
        timer_.cancel();
      });
    });
    io_.run();
    browser.join();
    return seen;
  }

  asio::io_context io_{1};
  Server server_{io_.get_executor(), {.port = 0, .name = "drydock demo"}, page_files()};
  MadeUpBench bench_{server_};
  asio::steady_timer timer_{io_};
  bool stopped_ = false;
};

TEST_P(LivePage, ShowsHealthEstimatesAndMeasurementsAtThisWidthAndInThisLight) {
  auto seen = look(GetParam());
  ASSERT_TRUE(seen.contains("devices")) << seen;
  EXPECT_TRUE(seen["errors"].empty()) << seen["errors"];
  EXPECT_EQ(seen["rig"], "demo");
  EXPECT_EQ(seen["link"], "live");
  EXPECT_LE(seen["overflow"], 0);  // nothing to scroll sideways
  EXPECT_EQ(seen["background"],
            std::string(GetParam().theme) == "dark" ? "rgb(17, 22, 28)" : "rgb(246, 247, 249)");
  ASSERT_EQ(seen["devices"].size(), 2U);
  EXPECT_EQ(seen["devices"][1].dump(), R"(["dvl","degraded","no bottom lock for 3 s"])");
  auto& figures = seen["figures"];
  const auto drawn = [&](const std::string& title, const char* colour) {
    return figures.contains(title) ? figures[title].value(colour, 0) : -1;
  };
  EXPECT_GT(drawn("leveling: roll [deg]", "--c1"), 50);
  EXPECT_GT(drawn("leveling: pitch [deg]", "--c1"), 50);
  EXPECT_GT(drawn("leveling: roll [deg]", "--c2"), 50);  // the truth
  EXPECT_GT(drawn("leveling: position error [m]", "--c1"), 50);
  EXPECT_GT(drawn("leveling: velocity error [m/s]", "--c1"), 50);
  EXPECT_GT(drawn("dvl: velocity over the bed [m/s, body]", "--c1"), 50);
  EXPECT_GT(drawn("dvl: velocity over the bed [m/s, body]", "--c2"), 50);
  EXPECT_GT(drawn("depth: depth [m]", "--c1"), 50);
  EXPECT_GT(drawn("imu: specific force [m/s², forward left up]", "--c3"), 50);
  EXPECT_GT(drawn("Track [m, east to the right, north up]", "--c1"), 20);
  EXPECT_GT(drawn("Satellites [north up; size and number: C/N0, dB-Hz]", "--ok"), 50);
}

INSTANTIATE_TEST_SUITE_P(Looks, LivePage, testing::Values(Look{1280, "light"}, Look{400, "dark"}),
                         [](const auto& look) {
                           return std::string(look.param.theme) + std::to_string(look.param.width);
                         });

}  // namespace page_test
}  // namespace drydock::live
