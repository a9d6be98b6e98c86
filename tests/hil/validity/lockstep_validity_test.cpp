#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "drivers/device/make_driver.hpp"
#include "drivers/link/uri.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "hil/bench/run.hpp"
#include "hil/emulate/line_pacer.hpp"
#include "hil/emulate/make_emulated_device.hpp"
#include "hil/motion/make_trajectory.hpp"
#include "hil/validity/figures.hpp"
#include "hil/validity/run/sent_and_heard.hpp"
#include "rig_config/load.hpp"

namespace {

using namespace drydock;
using measurement::Stamp;

/// The smallest and the largest error that the documents explain, nanoseconds:
/// docs/sensors/time-of-validity.md.
struct Budget {
  double least_ns, greatest_ns;
};

/// The line's time is rounded up to nanoseconds when a sentence is sent and rounded down when it is
/// subtracted, once per sentence.
constexpr Budget of_a_line{0, 12};
constexpr Budget of_a_bus{0, 1};
/// A link without a line rate takes 10 ns a byte, of which the driver knows nothing.
constexpr Budget of_a_socket{0, 10 * 1100};
/// The rate's latency has steps of 0.5 ms. The sensor counts two frames of 0.54 ms, which really
/// take 0.52 to 0.64 ms each.
constexpr Budget of_stated_age{-250e3 - 2 * 16e3, 250e3 + 2 * 100e3};

Budget budget_of(const std::string& device, bool on_bus) {
  if (device == "aceinna" || device == "microstrain_mv5") return of_stated_age;
  if (device == "water_linked_json") return of_a_socket;
  return on_bus ? of_a_bus : of_a_line;
}

rig_config::Rig every_protocol() {
  return rig_config::load_rig(DRYDOCK_SOURCE_DIR "/rig_config/rigs/every-protocol.toml").value();
}

bool on_bus(const rig_config::DeviceConfig& device) {
  return link::parse_uri(device.link)->carries() != link::Carries::bytes;
}

bool without_line_rate(const rig_config::DeviceConfig& device) {
  return !link::parse_uri(device.link)->baud();
}

std::vector<std::string> names_of(const rig_config::Rig& rig) {
  std::vector<std::string> names;
  for (const auto& device : rig.devices) names.push_back(device.name);
  return names;
}

std::vector<validity::Figures> measured(const rig_config::Rig& rig, double duration_s) {
  validity::Listener listener(names_of(rig));
  bench::RunOptions options;
  options.duration_s = duration_s;
  options.lockstep = true;
  validity::SentAndHeard sent_and_heard(listener);
  options.followers = {&sent_and_heard};
  testing::internal::CaptureStdout();
  bench::run_lockstep(rig, options);
  testing::internal::GetCapturedStdout();
  return listener.figures();
}

void expect_within_budget(const rig_config::Rig& rig,
                          const std::vector<validity::Figures>& figures) {
  std::map<std::string, std::size_t> heard;
  for (const auto& of : figures) {
    const auto device = std::ranges::find(rig.devices, of.device, &rig_config::DeviceConfig::name);
    const Budget budget = budget_of(of.device, on_bus(*device));
    const auto [least, greatest] = std::ranges::minmax(of.errors_us);
    EXPECT_GE(least * 1e3, budget.least_ns) << of.device << ' ' << of.what;
    EXPECT_LE(greatest * 1e3, budget.greatest_ns) << of.device << ' ' << of.what;
    EXPECT_EQ(of.unpaired, 0U) << of.device << ' ' << of.what;
    heard[of.device] += of.errors_us.size();
  }
  for (const auto& device : rig.devices) EXPECT_GT(heard[device.name], 5U) << device.name;
}

TEST(LockstepValidity, EveryProtocolIsWithinTheBudgetOfItsDocuments) {
  const auto rig = every_protocol();
  expect_within_budget(rig, measured(rig, 75));
}

TEST(LockstepValidity, EveryBaudRateIsWithinTheSameBudget) {
  for (const unsigned baud : {4800, 9600, 19200, 38400, 57600, 230400, 460800, 921600}) {
    auto rig = every_protocol();
    std::erase_if(rig.devices, without_line_rate);
    for (auto& device : rig.devices) {
      device.link = "pty:" + device.name + "?baud=" + std::to_string(baud);
      device.rate_hz = baud < 20'000 ? 0.25 : 2;  // the longest ensemble needs this
    }
    SCOPED_TRACE(baud);
    expect_within_budget(rig, measured(rig, baud < 20'000 ? 60 : 20));
  }
}

/// How a driver gets the bytes of a line.
enum class Reads { in_chunks, whole_bursts };

/// A serial device whose bytes reach its driver in other pieces than whole messages.
class Pieces final : public device::Output {
 public:
  Pieces(const rig_config::Rig& rig, std::size_t i, const motion::Trajectory& truth, Reads reads)
      : listener_(names_of(rig)),
        name_(rig.devices[i].name),
        device_(emulate::make_emulated_device(rig.devices[i], truth, rig.seed).value()),
        driver_(*device::make_byte_driver(shell::device_options(rig, i)->driver)),
        pacer_(link::parse_uri(rig.devices[i].link)->baud().value_or(emulate::without_line_rate),
               std::chrono::milliseconds{4}),
        reads_(reads),
        now_(truth.start()) {
    driver_->restart(now_, *this);
  }

  std::vector<validity::Figures> run(std::chrono::seconds duration) {
    for (const Stamp end = now_ + duration; now_ < end;) step();
    return listener_.figures();
  }

 private:
  struct ToLine final : emulate::Wire {
    explicit ToLine(Pieces& all) : of(all) {}
    void send(wire::Bytes bytes) override {
      of.pacer_.queue(bytes, of.now_, of.device_->sampled_at());
    }
    void send(const wire::CanFrame&) override {}
    Pieces& of;
  };

  void step() {
    Stamp next = device_->deadline().value();
    if (const auto line = pacer_.deadline()) next = std::min(next, *line);
    if (const auto driver = driver_->deadline()) next = std::min(next, *driver);
    now_ = std::max(now_, next);
    while (const auto chunk = pacer_.take(now_)) {
      held_.insert(held_.end(), chunk->bytes.begin(), chunk->bytes.end());
      if (chunk->ends_message) listener_.note(name_, chunk->of_message, chunk->at);
      if (reads_ == Reads::in_chunks || !pacer_.deadline()) read();
    }
    if (driver_->deadline() && *driver_->deadline() <= now_) driver_->tick(now_, *this);
    if (*device_->deadline() <= now_) device_->tick(now_, line_);
  }

  void read() {
    driver_->receive(held_, now_, *this);
    held_.clear();
  }

  void publish(const measurement::Measurement& m) override { listener_.note(m); }
  void send(std::span<const std::uint8_t> bytes) override { device_->receive(bytes, now_, line_); }
  void send(const wire::CanFrame&) override {}

  validity::Listener listener_;
  std::string name_;
  std::unique_ptr<emulate::EmulatedDevice> device_;
  std::unique_ptr<device::ByteDriver> driver_;
  emulate::LinePacer pacer_;
  ToLine line_{*this};
  Reads reads_;
  Stamp now_;
  std::vector<std::uint8_t> held_;
};

TEST(LockstepValidity, ItDoesNotMatterInWhichPiecesTheBytesAreRead) {
  const auto rig = every_protocol();
  const auto truth =
      motion::make_trajectory(rig.mission, measurement::stamp_from_ns(rig.start_utc_ns));
  for (const Reads reads : {Reads::in_chunks, Reads::whole_bursts}) {
    for (std::size_t i = 0; i < rig.devices.size(); ++i) {
      if (on_bus(rig.devices[i])) continue;
      auto alone = rig;
      alone.devices = {rig.devices[i]};
      SCOPED_TRACE(reads == Reads::in_chunks ? "chunks of 4 ms" : "a sample at once");
      auto figures = Pieces(rig, i, *truth, reads).run(std::chrono::seconds{20});
      expect_within_budget(alone, figures);
    }
  }
}

}  // namespace
