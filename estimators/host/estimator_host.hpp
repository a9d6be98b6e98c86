#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>

#include "drivers/bus/subscriber.hpp"
#include "estimators/host/bus_estimates.hpp"
#include "estimators/pipeline/pipeline.hpp"

namespace drydock::host {

/// The estimators of a rig in real time: measurements come from the bus, estimates go to a
/// follower.
class EstimatorHost final {
 public:
  /// Throws std::invalid_argument with one line when an estimator lacks a device that it needs.
  /// Subscriber and follower must outlive the host.
  EstimatorHost(boost::asio::io_context& io, const pipeline::PipelineOptions& options,
                bus::Subscriber& from, Follower& to);
  ~EstimatorHost();
  EstimatorHost(const EstimatorHost&) = delete;
  EstimatorHost& operator=(const EstimatorHost&) = delete;

  /// Tells this follower, which must outlive the host, the measurements before the estimators get
  /// them, and the time a few times a second.
  void tell_measurements(Follower& to) { hears_ = &to; }

  void start();
  void stop();
  pipeline::Pipeline& pipeline() { return pipeline_; }

 private:
  void wait_for_measurements();
  void wait_for_window();

  bus::Subscriber& from_;
  EstimateTeller teller_;
  pipeline::Pipeline pipeline_;
  boost::asio::posix::stream_descriptor readable_;
  boost::asio::steady_timer window_timer_;
  std::chrono::nanoseconds window_;
  Follower* hears_ = nullptr;  ///< may be null
  bool stopped_ = false;       ///< a timer that has expired can no longer be cancelled
};

}  // namespace drydock::host
