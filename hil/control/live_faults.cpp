#include "hil/control/live_faults.hpp"

#include <fmt/format.h>

#include "drivers/link/clock.hpp"
#include "hil/control/orders.hpp"

namespace drydock::control {

LiveFaults::LiveFaults(boost::asio::io_context& io, const rig_config::Rig& rig,
                       const motion::Trajectory& trajectory, measurement::Stamp start)
    : rig_(rig),
      start_(start),
      injector_(rig, trajectory, start),
      chronicle_(injector_, start),
      timer_(io) {
  chronicle_.set_on_change([this](const fault::Episode& episode) { changed(episode); });
}

void LiveFaults::start(std::function<void()> wake, OnLine on_line) {
  wake_ = std::move(wake);
  on_line_ = std::move(on_line);
  auto opened = ControlSocket::open(timer_.get_executor(), control_path(rig_.name),
                                    [this](std::string_view request) { return answer(request); });
  if (opened)
    socket_ = std::move(*opened);
  else
    on_line_("no faults by hand in this run: " + opened.error());
  follow();
}

void LiveFaults::stop() {
  stopped_ = true;
  socket_.reset();
  chronicle_.follow(link::steady_now());
  on_line_ = [](const std::string&) {};
  timer_.cancel();
  wake_ = [] {};
}

void LiveFaults::changed(const fault::Episode& episode) {
  on_line_(line_of(episode, start_));
  on_change_(episode);
}

/// Sets the timer for the next start or end of a fault.
void LiveFaults::follow() {
  chronicle_.follow(link::steady_now());
  const auto next = chronicle_.deadline();
  if (!next || stopped_) {
    timer_.cancel();
    return;
  }
  timer_.expires_after(*next - link::steady_now());
  timer_.async_wait([this](const boost::system::error_code& cancelled) {
    if (!cancelled && !stopped_) follow();
  });
}

std::string LiveFaults::answer(std::string_view request) {
  chronicle_.follow(link::steady_now());
  std::string line = obey(request, rig_, injector_, start_, link::steady_now());
  wake_();
  follow();
  return line;
}

void LiveFaults::write(summary::Summary& summary) const {
  control::write(chronicle_, start_, summary);
}

void write(const fault::Chronicle& chronicle, measurement::Stamp start, summary::Summary& summary) {
  for (const fault::Episode& episode : chronicle.episodes()) {
    summary::FaultSummary fault{
        episode.device, episode.words, measurement::seconds(episode.since - start), {}};
    if (episode.until) fault.until_s = measurement::seconds(*episode.until - start);
    summary.faults.push_back(std::move(fault));
  }
  if (chronicle.not_kept() > 0)
    summary.notes.push_back(
        fmt::format("{} more faults than this summary keeps", chronicle.not_kept()));
}

std::string line_of(const fault::Episode& episode, measurement::Stamp start) {
  const measurement::Stamp at = episode.until.value_or(episode.since);
  return fmt::format("{:.3f} s fault {}: {}", measurement::seconds(at - start),
                     episode.until ? "cleared" : "set", episode.words);
}

}  // namespace drydock::control
