#include "estimators/host/estimator_host.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "drivers/link/link.hpp"

namespace drydock::host {
namespace {

pipeline::Pipeline made(const pipeline::PipelineOptions& options,
                        pipeline::EstimateListener& listener) {
  auto pipeline = pipeline::make_pipeline(options, listener);
  if (!pipeline) throw std::invalid_argument(pipeline.error().message);
  return std::move(*pipeline);
}

}  // namespace

EstimatorHost::EstimatorHost(boost::asio::io_context& io, const pipeline::PipelineOptions& options,
                             bus::Subscriber& from, Follower& to)
    : from_(from),
      teller_(to),
      pipeline_(made(options, teller_)),
      readable_(io, from.fd()),
      window_timer_(io),
      window_(options.reorder_window) {}

EstimatorHost::~EstimatorHost() { readable_.release(); }  // the subscriber owns the descriptor

void EstimatorHost::start() {
  wait_for_measurements();
  wait_for_window();
}

void EstimatorHost::stop() {
  if (std::exchange(stopped_, true)) return;
  readable_.cancel();
  window_timer_.cancel();
  pipeline_.flush();
}

void EstimatorHost::wait_for_measurements() {
  readable_.async_wait(readable_.wait_read, [this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    from_.take_measurements([this](const measurement::Measurement& m) {
      if (hears_ != nullptr) hears_->on_measurement(m);
      pipeline_.receive(m);
    });
    wait_for_measurements();
  });
}

void EstimatorHost::wait_for_window() {
  const std::chrono::nanoseconds half =
      window_ > std::chrono::nanoseconds{0} ? window_ / 2 : std::chrono::milliseconds{250};
  window_timer_.expires_after(std::max(half, std::chrono::nanoseconds{10'000'000}));
  window_timer_.async_wait([this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    // Without a window no measurement waits in the pipeline.
    if (window_ > std::chrono::nanoseconds{0}) pipeline_.advance(link::now());
    if (hears_ != nullptr) hears_->tick(link::now());
    wait_for_window();
  });
}

}  // namespace drydock::host
