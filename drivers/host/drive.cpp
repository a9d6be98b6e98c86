#include "drivers/host/drive.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <optional>
#include <stdexcept>
#include <utility>

#include "drivers/bus/participant.hpp"
#include "drivers/host/driver_host.hpp"
#include "drivers/host/finding_lines.hpp"
#include "drivers/host/late_wakes.hpp"
#include "drivers/host/page_recorder.hpp"
#include "drivers/host/rig_bus.hpp"
#include "drivers/host/rig_publisher.hpp"
#include "drivers/host/state_lines.hpp"
#include "drivers/host/status_line.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/clock.hpp"
#include "drivers/link/link.hpp"
#include "drivers/shell/rig_devices.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/service_manager.hpp"

namespace drydock::host {
namespace {

using measurement::Stamp;

constexpr std::chrono::milliseconds tick_period{200};
constexpr std::chrono::seconds absent_after{3};

/// Bytes that no driver understands come from somebody, too.
bool nobody_there(const shell::RealTime& shell) {
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const auto& device = shell.device(i);
    const bool emulated = provenance_of(device.options().link) == measurement::Provenance::emulated;
    if (!emulated || device.messages() > 0 || shell.health(i).stream.bytes_in > 0) return false;
  }
  return true;
}

void print_health(const shell::RealTime& shell) {
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const auto h = shell.health(i);
    fmt::print("{}: {}, {:.2f} Hz of {:.1f}, {} messages, {} bytes skipped, {} bad checksums\n",
               shell.device(i).name(), to_string(h.state), h.rate_hz.value_or(0), h.nominal_rate_hz,
               h.messages, h.stream.bytes_skipped, h.stream.bad_checksums);
  }
}

void print_line(const std::string& line) {
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

/// Runs the drivers and their followers until the time is over or Ctrl-C.
class Drive {
 public:
  Drive(const rig_config::Rig& rig, const DriveOptions& options,
        std::vector<std::unique_ptr<device::Device>> devices)
      : options_(options),
        participant_(static_cast<std::uint32_t>(rig.dds_domain), rig.dds_interface),
        publisher_(participant_, bus_devices(rig)),
        status_line_([this] { return standing(); }),
        finding_lines_(rig, link::now(), print_line),
        host_(io_, std::move(devices), followers_) {
    followers_.add(status_line_);
    followers_.add(publisher_);
    if (options.beside) {
      beside_ = options.beside(rig, host_.devices(), followers_);
      followers_.add(*beside_);
    }
    followers_.add(state_lines_);
    followers_.add(finding_lines_);
    followers_.add(late_wakes_);
    if (options.hints) followers_.add(hint_lines_.emplace(options.hints, host_.devices()));
    if (!options.record.path.empty())
      followers_.add(recorder_.emplace(rig, options.record, link::now(), record::WhenBehind::lose));
    if (options.serve.address.empty()) return;
    followers_.add(viewer_.emplace(io_.get_executor(), rig, options.serve));
    if (!options.serve.recordings.empty()) {
      followers_.add(page_recorder_.emplace(rig, options.serve.recordings, link::now));
      viewer_->add(page_recorder_->services());
    }
    if (options.behind_page) {
      behind_page_ = options.behind_page(io_.get_executor(), *viewer_, followers_);
      followers_.add(*behind_page_);
    }
    fmt::print("live: {}\n", viewer_->url());
  }

  int run() {
    io::UntilStopped until(io_, options_.duration_s, [this] { stop(); });
    keep_ticking();
    host_.start();
    service_manager_.ready();
    io_.run();
    if (const auto note = late_wakes_.note(); !note.empty()) print_line(note);
    if (recorder_) fmt::print("{}\n", recorder_->finish());
    if (page_recorder_ && page_recorder_->records()) fmt::print("{}\n", page_recorder_->finish());
    return terminal::exit_of(all_streaming_ && !(recorder_ && recorder_->failed()));
  }

 private:
  RunStanding standing() const {
    RunStanding standing;
    standing.elapsed_s = measurement::seconds(link::steady_now() - start_);
    standing.duration_s = options_.duration_s;
    if (recorder_) standing.recorded = recorder_->bytes();
    const auto& shell = host_.shell();
    for (std::size_t i = 0; i < shell.size(); ++i)
      standing.rates_hz.emplace_back(shell.device(i).name(), shell.health(i).rate_hz.value_or(0));
    return standing;
  }

  /// Once, when the first seconds, or a shorter run, brought nothing from a rig that only has
  /// emulated devices.
  void tell_absence() {
    if (std::exchange(told_absence_, true) || !nobody_there(host_.shell())) return;
    status_line_.wipe();
    print_line(
        "nothing is there: all devices of this rig are emulated; `drydock emulate` makes them, or "
        "`drydock run --record`");
  }

  void tell(const std::vector<std::string>& lines) {
    if (!lines.empty()) status_line_.wipe();
    for (const auto& line : lines) print_line(line);
  }

  void keep_ticking() {
    timer_.expires_after(tick_period);
    timer_.async_wait([this](const boost::system::error_code& ec) {
      if (ec || stopped_) return;  // an expired timer can no longer be cancelled
      const auto now = link::now();
      followers_.tick(now);
      service_manager_.alive();
      if (link::steady_now() - start_ >= absent_after) tell_absence();
      if (hint_lines_) tell(hint_lines_->news());
      keep_ticking();
    });
  }

  void stop() {
    stopped_ = true;
    service_manager_.stopping();
    all_streaming_ = host_.all_streaming();
    status_line_.wipe();
    tell_absence();
    if (hint_lines_) tell(hint_lines_->last());
    print_health(host_.shell());
    timer_.cancel();
    host_.stop();
    if (viewer_) viewer_->stop();
  }

  const DriveOptions& options_;
  boost::asio::io_context io_{1};
  bus::Participant participant_;
  RigPublisher publisher_;
  StateLines state_lines_{stdout};
  StatusLine status_line_;
  FindingLines finding_lines_;
  LateWakes late_wakes_;
  Followers followers_;
  std::optional<RigRecorder> recorder_;
  std::optional<PageRecorder> page_recorder_;
  std::optional<RigViewer> viewer_;
  std::optional<HintLines> hint_lines_;
  std::shared_ptr<Follower> behind_page_, beside_;
  DriverHost host_;
  boost::asio::steady_timer timer_{io_};
  terminal::ServiceManager service_manager_;
  Stamp start_ = link::steady_now();
  bool stopped_ = false, all_streaming_ = false, told_absence_ = false;
};

}  // namespace

int drive(const rig_config::Rig& rig, const DriveOptions& options) {
  auto devices = shell::make_devices(rig);
  if (!devices) throw std::runtime_error(devices.error().message);
  Drive drive(rig, options, std::move(*devices));
  return drive.run();
}

}  // namespace drydock::host
