#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "drivers/bus/participant.hpp"
#include "drivers/bus/publisher.hpp"
#include "drivers/bus/subscriber.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"
#include "drivers/monitor/live_table.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "estimators/host/estimator_host.hpp"
#include "estimators/setup/rig_pipeline.hpp"
#include "hil/bench/run.hpp"
#include "hil/bench/run_watchers.hpp"
#include "hil/control/fault_services.hpp"
#include "hil/control/live_faults.hpp"
#include "hil/emulate/real_time/real_time.hpp"
#include "hil/summary/expect_watch.hpp"
#include "hil/summary/scribe.hpp"
#include "hil/summary/truth_of_rig.hpp"

namespace drydock::bench {
namespace {

namespace asio = boost::asio;

constexpr std::chrono::milliseconds redraw_period{500};

template <class T>
T or_throw(boost::system::result<T, shell::RigDevicesError> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// A whole rig on one thread. Members are in the order in which they need each other.
class Bench {
 public:
  Bench(const rig_config::Rig& rig, const RunOptions& options)
      : rig_(rig),
        options_(options),
        start_(link::steady_now()),
        trajectory_(motion::make_trajectory(rig.mission, start_)),
        participant_(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface),
        publisher_(participant_, host::bus_devices(rig), host::estimator_names(rig),
                   host::navigator_names(rig)),
        subscriber_(participant_, host::bus_devices(rig)),
        faults_(io_, rig, *trajectory_, start_),
        emulator_(io_, faults_.injector()),
        watchers_(rig, summary::truth_for_estimators(rig) ? trajectory_.get() : nullptr),
        drivers_(io_, or_throw(shell::make_devices(rig)), &publisher_, &watchers_.all),
        estimators_(io_, setup::pipeline_options(rig), subscriber_, publisher_),
        scribe_(rig, summary::truth_for_estimators(rig) ? trajectory_.get() : nullptr, start_,
                options.duration_s > 0 ? options.duration_s : 600),
        expects_(rig, summary::truth_for_estimators(rig) ? trajectory_.get() : nullptr, start_) {
    if (!options.record.path.empty()) {
      recorder_.emplace(rig, options.record, start_, record::WhenBehind::lose);
      watchers_.all.add(*recorder_);
    }
    if (!options.serve.address.empty()) {
      viewer_.emplace(io_.get_executor(), rig, options.serve);
      watchers_.all.add(*viewer_);
      if (options.serve.allow_faults)
        viewer_->add(
            control::fault_services(rig, [this](const std::string& order, const auto& answered) {
              answered(faults_.answer(order));
            }));
      fmt::print("live: {}\n", viewer_->url());
    }
  }

  summary::Summary run() {
    connect();
    if (options_.on_written) emulator_.set_on_written(options_.on_written);
    if (auto started = emulator_.start(summary::emulated_devices(rig_)); !started) {
      throw std::runtime_error(started.error().message);
    }
    faults_.set_on_change([this](const fault::Episode&) {
      const auto now = link::now();
      tell_faults_to(watchers_.all, faults_.injector().in_force(now), now);
    });
    faults_.start([this] { emulator_.wake(); },
                  [this](const std::string& line) { live_.note(line); });
    estimators_.start();
    drivers_.start();
    signals_.async_wait([this](const boost::system::error_code& ec, int) {
      if (ec) return;
      interrupted_ = true;
      stop();
    });
    schedule_redraw();
    io_.run();
    live_.finish();
    return summary();
  }

 private:
  void connect() {
    drivers_.on_measurement_hook = [this](const measurement::Measurement& m) {
      scribe_.note(m);
      watchers_.all.note(m);
      if (options_.on_measurement) options_.on_measurement(m);
    };
    drivers_.on_health_hook = [this](auto health, measurement::Stamp now) {
      watchers_.all.note(health, now);
    };
    drivers_.on_state_hook = [this](const device::Device& d, const device::Transition& change) {
      if (stopping_) return;
      expects_.note(d.name(), change);
      if (!options_.on_progress) live_.note(d.name(), change);
    };
    estimators_.on_attitude_hook = [this](const pipeline::AttitudeEstimate& e) {
      scribe_.note(e);
      expects_.note(e);
      watchers_.note(e);
    };
    estimators_.on_navigation_hook = [this](const pipeline::NavigationEstimate& e) {
      scribe_.note(e);
      expects_.note(e);
      watchers_.note(e);
    };
    estimators_.on_innovation_hook = [this](const pipeline::InnovationReport& r) {
      watchers_.note(r);
    };
  }

  double elapsed() const { return measurement::seconds(link::steady_now() - start_); }

  void schedule_redraw() {
    timer_.expires_after(redraw_period);
    timer_.async_wait([this](const boost::system::error_code& ec) {
      if (ec || stopping_) return;  // an expired timer cannot be cancelled any more
      scribe_.follow(link::now());
      expects_.follow(
          link::now(), [this] { return devices(); }, estimators_.pipeline());
      watchers_.all.tick(link::now());
      if (options_.on_progress)
        options_.on_progress(elapsed() / options_.duration_s);
      else
        live_.draw(drivers_.shell(), elapsed(), options_.duration_s);
      if (options_.duration_s > 0 && elapsed() >= options_.duration_s) return stop();
      schedule_redraw();
    });
  }

  std::vector<summary::DeviceSummary> devices() const {
    std::vector<summary::DeviceSummary> all;
    for (std::size_t i = 0; i < drivers_.shell().size(); ++i) {
      const auto& device = drivers_.shell().device(i);
      all.push_back(device::account_of(device, drivers_.shell().health(i),
                                       host::provenance_of(device.options().link)));
    }
    return all;
  }

  // Takes the health just before the links are closed, because that state is reported.
  void stop() {
    if (stopping_) return;
    stopping_ = true;
    end_ = link::steady_now();
    devices_ = devices();
    signals_.cancel();
    signals_.clear();  // a second Ctrl-C ends the program at once
    timer_.cancel();
    drivers_.stop();
    estimators_.stop();
    faults_.stop();
    emulator_.stop();
    if (viewer_) viewer_->stop();
  }

  summary::Summary summary() {
    summary::Summary s;
    s.rig = rig_.name;
    s.mode = "real time";
    s.seed = rig_.seed;
    s.duration_s = s.wall_s = measurement::seconds(end_ - start_);
    s.interrupted = interrupted_;
    s.devices = devices_;
    s.notes = summary::can_notes(rig_);
    if (const auto counters = emulator_.counters();
        counters.lost > 0 || counters.write_errors > 0) {
      s.notes.push_back("emulated devices lost " + std::to_string(counters.lost) +
                        " messages to overloaded lines, " + std::to_string(counters.write_errors) +
                        " to write errors");
    }
    std::ranges::move(setup::pipeline_notes(rig_, estimators_.pipeline()),
                      std::back_inserter(s.notes));
    if (recorder_) s.notes.push_back(recorder_->finish());
    scribe_.write(s);
    expects_.write(s, estimators_.pipeline());
    faults_.write(s);
    return s;
  }

  const rig_config::Rig& rig_;
  const RunOptions& options_;
  asio::io_context io_{1};
  measurement::Stamp start_, end_{};
  std::unique_ptr<motion::Trajectory> trajectory_;
  bus::Participant participant_;
  bus::Publisher publisher_;
  bus::Subscriber subscriber_;
  control::LiveFaults faults_;
  emulate::RealTimeEmulator emulator_;
  RunWatchers watchers_;
  std::optional<host::RigRecorder> recorder_;
  std::optional<host::RigViewer> viewer_;
  host::DriverHost drivers_;
  host::EstimatorHost estimators_;
  summary::Scribe scribe_;
  summary::ExpectWatch expects_;
  monitor::LiveTable live_;
  asio::steady_timer timer_{io_};
  asio::signal_set signals_{io_, SIGINT, SIGTERM};
  std::vector<summary::DeviceSummary> devices_;
  bool stopping_ = false;
  bool interrupted_ = false;
};

}  // namespace

summary::Summary run_real_time(const rig_config::Rig& rig, const RunOptions& options) {
  Bench bench(rig, options);
  return bench.run();
}

}  // namespace drydock::bench
