#include "hil/control/remote_faults.hpp"

#include <fmt/format.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <nlohmann/json.hpp>

#include "drivers/link/link.hpp"
#include "hil/control/bus_faults.hpp"
#include "hil/control/control_socket.hpp"
#include "hil/control/request/order_text.hpp"

namespace drydock::control {

namespace {

namespace asio = boost::asio;
using nlohmann::json;

std::string refusal_line(const std::string& why) {
  return json{{"ok", false}, {"lines", {why}}}.dump();
}

measurement::Stamp seconds_after(measurement::Stamp start, const json& seconds) {
  return start + measurement::from_seconds(seconds.get<double>());
}

}  // namespace

RemoteFaults::RemoteFaults(asio::any_io_executor executor, const rig_config::Rig& rig,
                           host::Follower& to)
    : executor_(std::move(executor)),
      path_(control_path(rig.name)),
      nobody_(fmt::format("no bench of rig \"{}\" runs here; start one: drydock emulate {}",
                          rig.name, rig.file)),
      to_(to) {}

void RemoteFaults::obey(const std::string& order,
                        std::function<void(const std::string&)> answered) {
  if (asking_ >= most_asking) return answered(refusal_line("too many orders wait for the bench"));
  ++asking_;
  asio::co_spawn(
      executor_,
      [self = shared_from_this(), order,
       answered = std::move(answered)]() -> asio::awaitable<void> {
        const auto answer = co_await ask_soon(self->path_, order);
        --self->asking_;
        answered(answer ? *answer : refusal_line(self->nobody_));
      },
      asio::detached);
}

void RemoteFaults::tick(measurement::Stamp now) {
  constexpr std::chrono::seconds period{1};
  if (now >= asked_ && now - asked_ < period) return;
  asked_ = now;
  obey(order_to_list(),
       [self = shared_from_this()](const std::string& answer) { self->take(answer, link::now()); });
}

/// The bench's times count from its start. The start is computed once, because each answer has a
/// different delay; a large difference means that the bench was restarted.
void RemoteFaults::take(const std::string& answer, measurement::Stamp now) try {
  constexpr std::chrono::milliseconds restarted{200};
  const json list = json::parse(answer);
  std::vector<fault::FaultNow> faults;
  if (list.at("ok")) {
    const auto start = seconds_after(now, -list.at("now_s").get<double>());
    if (!start_ || start > *start_ + restarted || start < *start_ - restarted) start_ = start;
    for (const json& fault : list.at("faults")) {
      faults.push_back({fault.at("device"),
                        fault.at("fault"),
                        fault.at("words"),
                        seconds_after(*start_, fault.at("since_s")),
                        {}});
      if (const json& until = fault.at("until_s"); !until.is_null())
        faults.back().until = seconds_after(*start_, until);
    }
  }
  if (faults == told_) return;
  told_ = std::move(faults);
  to_.on_faults(bus_faults(told_), now);
} catch (const json::exception&) {
  start_.reset();  // The bench has another version, so its faults are not known.
}

}  // namespace drydock::control
