#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "drivers/bus/participant.hpp"
#include "drivers/bus/subscriber.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/finding_lines.hpp"
#include "drivers/host/page_recorder.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/host/rig_publisher.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"
#include "drivers/monitor/live_table.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "estimators/host/estimator_host.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/bus_truth.hpp"
#include "hil/bench/joint_troubles.hpp"
#include "hil/bench/rig_run.hpp"
#include "hil/bench/run.hpp"
#include "hil/bench/told_log.hpp"
#include "hil/control/fault_services.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/motion/ordered/takes_orders.hpp"
#include "hil/pilot/real_time/real_time_pilot.hpp"
#include "hil/steer/real_time/autopilot_server.hpp"
#include "hil/steer/real_time/dds_steering.hpp"
#include "hil/summary/truth_of_rig.hpp"
#include "rig_config/steering.hpp"

namespace drydock::bench {
namespace {

constexpr std::chrono::milliseconds tick_period{500};
constexpr double usual_s = 600;  ///< for a run without an end

std::vector<std::unique_ptr<device::Device>> devices_of(const rig_config::Rig& rig) {
  auto devices = shell::make_devices(rig);
  if (!devices) throw std::runtime_error(devices.error().message);
  return std::move(*devices);
}

/// A whole rig on one thread. Measurements go from the drivers over DDS to the estimators. Members
/// are in the order in which they need each other.
class RealTimeRun {
 public:
  RealTimeRun(const rig_config::Rig& rig, const RunOptions& options)
      : rig_(rig),
        duration_s_(options.duration_s),
        start_(link::steady_now()),
        trajectory_(motion::make_trajectory(rig.mission, start_)),
        participant_(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface),
        publisher_(participant_, host::bus_devices(rig), host::estimator_names(rig),
                   host::navigator_names(rig)),
        subscriber_(participant_, host::bus_devices(rig),
                    {.estimators = {}, .diagnostics = false, .own_only = true}),
        run_(rig, options, *trajectory_,
             {start_, duration_s_ > 0 ? duration_s_ : usual_s, record::WhenBehind::lose,
              &publisher_}),
        faults_(io_, rig, *trajectory_, start_),
        emulator_(io_, faults_.injector()),
        drivers_(io_, devices_of(rig), run_.followers()),
        outside_{.lockstep = false, .say = [this](const std::string& line) { table_.note(line); }},
        estimators_(io_, setup::pipeline_options(rig, &outside_), subscriber_, run_.followers()),
        table_(drivers_.shell(), start_, duration_s_),
        finding_lines_(rig, start_, [this](const std::string& line) { table_.note(line); }) {
    if (!options.quiet) run_.followers().add(table_);
    if (!options.quiet) run_.followers().add(finding_lines_);
    if (auto* motion = motion::steered(*trajectory_)) steer_from_outside(*motion);
    if (pilot::is_wanted(rig))
      run_.followers().add(pilot_.emplace(
          io_, rig, start_,
          [this](const std::string& link, const wire::CanFrame& frame) {
            drivers_.send(link, frame);
          },
          [this](const std::string& line) { table_.note(line); }));
    if (!options.serve.address.empty()) serve(options.serve);
    if (rig.truth && summary::no_real_device(rig))
      run_.followers().add(bus_truth_.emplace(participant_, *trajectory_));
  }

  summary::Summary run() {
    run_.begin({start_, drivers_.devices(), estimators_.pipeline(), faults_.injector()});
    emulator_.set_on_written(run_.on_written());
    emulator_.set_on_told([this](std::string_view device, std::string_view what) {
      if (const auto line = told_.add(device, what); !line.empty()) table_.note(line);
      publisher_.tell({std::string(device), told_.latest(device)}, link::now());
    });
    // Before the first line: nobody may read it any more.
    io::UntilStopped until(io_, time_left(), [this] { stop(); });
    if (auto started = emulator_.start(summary::emulated_devices(rig_)); !started)
      throw std::runtime_error(started.error().message);
    faults_.set_on_change([this](const fault::Episode&) { run_.tell_faults(link::now()); });
    faults_.start([this] { emulator_.wake(); },
                  [this](const std::string& line) { table_.note(line); });
    estimators_.start();
    drivers_.start();
    if (pilot_) pilot_->start();
    if (autopilot_)
      table_.note(fmt::format("waits for an autopilot on UDP port {}", autopilot_->port()));
    if (dds_) {
      table_.note(fmt::format("waits for orders on {}", steer::order_topics));
      dds_->start();
    }
    keep_ticking();
    io_.run();
    table_.finish();
    summary_.interrupted = until.interrupted();
    summary_.mode = "real time";
    summary_.notes = summary::can_notes(rig_);
    std::ranges::move(told_.notes(), std::back_inserter(summary_.notes));
    if (autopilot_)
      std::ranges::move(autopilot_->session().notes(), std::back_inserter(summary_.notes));
    if (dds_) std::ranges::move(dds_->notes(), std::back_inserter(summary_.notes));
    if (const auto* orders = motion::orders_of(*trajectory_))
      std::ranges::move(motion::notes_of(orders->counters()), std::back_inserter(summary_.notes));
    note_losses();
    if (rig_.truth && !bus_truth_)
      summary_.notes.push_back("the truth is not published: a device of the rig is real");
    if (page_recorder_ && page_recorder_->records())
      summary_.notes.push_back(page_recorder_->finish());
    run_.write(summary_);
    faults_.write(summary_);
    return std::move(summary_);
  }

 private:
  void steer_from_outside(motion::SteeredTrajectory& motion) {
    const auto troubles = [this](measurement::Stamp now) {
      return joint_troubles(rig_, faults_.injector(), now);
    };
    if (rig_config::steered_over_dds(rig_.mission))
      dds_.emplace(io_, participant_, motion, rig_.mission, troubles,
                   [this](const std::string& line) { table_.note(line); });
    else
      autopilot_.emplace(io_, motion, rig_.mission, troubles);
  }

  void serve(const host::ServeOptions& options) {
    run_.followers().add(viewer_.emplace(io_.get_executor(), rig_, options));
    if (options.allow_faults) viewer_->add(control::fault_services(rig_, faults_));
    if (!options.recordings.empty()) {
      run_.followers().add(page_recorder_.emplace(rig_, options.recordings, link::now));
      viewer_->add(page_recorder_->services());
    }
    fmt::print("live: {}\n", viewer_->url());
  }

  /// 0: no limit.
  double time_left() const {
    constexpr double least_s = 1e-3;
    const double elapsed_s = measurement::seconds(link::steady_now() - start_);
    return duration_s_ > 0 ? std::max(duration_s_ - elapsed_s, least_s) : 0;
  }

  /// The ticks' time is that of start_: a step of the host's clock begins no expectation.
  void keep_ticking() {
    timer_.expires_after(tick_period);
    timer_.async_wait([this](const boost::system::error_code& ec) {
      if (ec || stopping_) return;  // an expired timer cannot be cancelled any more
      run_.followers().tick(link::steady_now());
      keep_ticking();
    });
  }

  // Takes the health just before the links are closed, because that state is reported.
  void stop() {
    stopping_ = true;
    run_.followers().tick(link::steady_now());
    const double elapsed_s = measurement::seconds(link::steady_now() - start_);
    summary_.duration_s = summary_.wall_s = elapsed_s;
    summary_.devices = run_.devices(link::now());
    timer_.cancel();
    drivers_.stop();
    estimators_.stop();
    faults_.stop();
    emulator_.stop();
    if (autopilot_) autopilot_->stop();
    if (dds_) dds_->stop();
    if (pilot_) pilot_->stop();
    if (viewer_) viewer_->stop();
  }

  void note_losses() {
    if (const auto foreign = subscriber_.foreign(); foreign > 0)
      summary_.notes.push_back(fmt::format(
          "another program publishes devices of these names in DDS domain {}: {} of its samples "
          "were not taken; ROS_DOMAIN_ID gives each bench a domain of its own",
          rig_.dds_domain, foreign));
    const auto lost = emulator_.counters();
    if (lost.not_taken > 0)
      summary_.notes.push_back(fmt::format(
          "{} bytes of emulated devices were not taken by programs that had a line open",
          lost.not_taken));
    if (lost.lost == 0 && lost.write_errors == 0) return;
    summary_.notes.push_back(fmt::format(
        "emulated devices lost {} messages to overloaded lines{}, {} to write errors", lost.lost,
        lost.lost > 0 ? " (" + emulator_.overloaded_links() + ")" : "", lost.write_errors));
  }

  const rig_config::Rig& rig_;
  double duration_s_;
  boost::asio::io_context io_{1};
  measurement::Stamp start_;
  std::unique_ptr<motion::Trajectory> trajectory_;
  bus::Participant participant_;
  host::RigPublisher publisher_;
  bus::Subscriber subscriber_;
  RigRun run_;
  control::LiveFaults faults_;
  emulate::RealTimeEmulator emulator_;
  std::optional<steer::AutopilotServer> autopilot_;
  std::optional<steer::DdsSteering> dds_;
  std::optional<pilot::RealTimePilot> pilot_;
  std::optional<host::PageRecorder> page_recorder_;
  std::optional<host::RigViewer> viewer_;
  std::optional<BusTruth> bus_truth_;  ///< empty: the truth is not on the bus
  host::DriverHost drivers_;
  setup::Outside outside_;
  host::EstimatorHost estimators_;
  monitor::LiveTable table_;
  host::FindingLines finding_lines_;
  ToldLog told_;
  boost::asio::steady_timer timer_{io_};
  summary::Summary summary_;
  bool stopping_ = false;
};

}  // namespace

summary::Summary run_real_time(const rig_config::Rig& rig, const RunOptions& options) {
  return RealTimeRun(rig, options).run();
}

}  // namespace drydock::bench
