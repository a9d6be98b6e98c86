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
                             bus::Subscriber& from, bus::Publisher& to)
    : from_(from),
      to_(to),
      pipeline_(made(options, *this)),
      readable_(io, from.fd()),
      window_timer_(io),
      window_(options.reorder_window) {}

EstimatorHost::~EstimatorHost() { readable_.release(); }  // the subscriber owns the descriptor

void EstimatorHost::start() {
  wait_for_measurements();
  // Without a window no measurement waits in the pipeline, so no timer is needed.
  if (window_ > std::chrono::nanoseconds{0}) wait_for_window();
}

void EstimatorHost::stop() {
  if (std::exchange(stopped_, true)) return;
  readable_.cancel();
  window_timer_.cancel();
  pipeline_.flush();
}

void EstimatorHost::on_attitude(const pipeline::AttitudeEstimate& estimate) {
  to_.publish(bus_attitude(estimate), estimate.estimator);
  if (on_attitude_hook) on_attitude_hook(estimate);
}

void EstimatorHost::on_navigation(const pipeline::NavigationEstimate& estimate) {
  to_.publish(bus_attitude(pipeline::attitude_of(estimate)), estimate.estimator);
  to_.publish(to_bus_(estimate), estimate.estimator);
  if (on_navigation_hook) on_navigation_hook(estimate);
}

void EstimatorHost::wait_for_measurements() {
  readable_.async_wait(readable_.wait_read, [this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    from_.take_measurements([this](const measurement::Measurement& m) { pipeline_.receive(m); });
    wait_for_measurements();
  });
}

void EstimatorHost::wait_for_window() {
  window_timer_.expires_after(std::max(window_ / 2, std::chrono::nanoseconds{10'000'000}));
  window_timer_.async_wait([this](const boost::system::error_code& ec) {
    if (ec || stopped_) return;
    pipeline_.advance(link::now());
    wait_for_window();
  });
}

}  // namespace drydock::host
