#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <functional>

#include "drivers/bus/publisher.hpp"
#include "drivers/bus/subscriber.hpp"
#include "estimators/host/bus_estimates.hpp"
#include "estimators/pipeline/pipeline.hpp"

namespace drydock::host {

/// The estimators of a rig in real time: measurements from the bus, estimates to the bus.
class EstimatorHost final : private pipeline::EstimateListener {
 public:
  /// Throws std::invalid_argument with one line when an estimator lacks a device that it needs.
  /// Subscriber and publisher must outlive the host.
  EstimatorHost(boost::asio::io_context& io, const pipeline::PipelineOptions& options,
                bus::Subscriber& from, bus::Publisher& to);
  ~EstimatorHost() override;
  EstimatorHost(const EstimatorHost&) = delete;
  EstimatorHost& operator=(const EstimatorHost&) = delete;

  /// Called for every estimate after it was published.
  std::function<void(const pipeline::AttitudeEstimate&)> on_attitude_hook;

  std::function<void(const pipeline::NavigationEstimate&)> on_navigation_hook;
  std::function<void(const pipeline::InnovationReport&)> on_innovation_hook;

  void start();
  void stop();
  const pipeline::Pipeline& pipeline() const { return pipeline_; }

 private:
  void on_attitude(const pipeline::AttitudeEstimate& estimate) override;
  void on_navigation(const pipeline::NavigationEstimate& estimate) override;
  void on_innovation(const pipeline::InnovationReport& report) override {
    if (on_innovation_hook) on_innovation_hook(report);
  }
  void wait_for_measurements();
  void wait_for_window();

  bus::Subscriber& from_;
  bus::Publisher& to_;
  pipeline::Pipeline pipeline_;
  boost::asio::posix::stream_descriptor readable_;
  boost::asio::steady_timer window_timer_;
  std::chrono::nanoseconds window_;
  BusNavigation to_bus_;
  bool stopped_ = false;  ///< a timer that has expired can no longer be cancelled
};

}  // namespace drydock::host
