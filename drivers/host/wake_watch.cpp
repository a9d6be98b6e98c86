#include "drivers/host/wake_watch.hpp"

#include "drivers/link/link.hpp"

namespace drydock::host {

void WakeWatch::start() {
  stopped_ = false;
  keep_asking();
}

void WakeWatch::stop() {
  stopped_ = true;
  timer_.cancel();
}

void WakeWatch::look() {
  if (stopped_) return;
  if (const auto late = times_.look(std::chrono::steady_clock::now())) {
    const auto now = link::now();
    to_.on_late_wake(now - *late, now);
  }
}

void WakeWatch::keep_asking() {
  timer_.expires_at(times_.ask(std::chrono::steady_clock::now()));
  timer_.async_wait([this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    look();
    keep_asking();
  });
}

}  // namespace drydock::host
