#include "drivers/host/rig_viewer.hpp"

#include <fmt/format.h>

#include <random>
#include <stdexcept>

#include "drivers/host/rig_bus.hpp"
#include "drivers/host/serve_address.hpp"
#include "drivers/live/foxglove/access.hpp"
#include "drivers/live/page_files.hpp"
#include "rig_config/estimator_name.hpp"

namespace drydock::host {

namespace {

std::vector<std::string> with_truth(std::vector<std::string> names) {
  names.emplace_back(rig_config::name_of_truth);
  return names;
}

std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += fmt::format("{:08x}", random());
  return token;
}

live::ServerOptions server_options(const std::string& name, const ServeOptions& options) {
  live::ServerOptions server;
  server.name = "drydock " + name;
  server.token = options.token;
  server.history = std::chrono::minutes{5};
  const auto address = parse_serve_address(options.address);
  if (!address) throw std::runtime_error("--serve: " + no_serve_address(options.address));
  if (!address->host.empty()) server.address = address->host;
  server.port = address->port;
  if (!live::is_loopback(server.address) && server.token.empty()) server.token = random_token();
  return server;
}

}  // namespace

Viewed viewed(const rig_config::Rig& rig) {
  return {rig.name, bus_devices(rig), estimator_names(rig), navigator_names(rig),
          innovation_sources(rig)};
}

RigViewer::RigViewer(boost::asio::any_io_executor executor, const Viewed& viewed,
                     const ServeOptions& options)
    : options_(server_options(viewed.name, options)),
      server_(std::move(executor), options_, live::page_files()),
      sink_(server_),
      topics_(sink_, viewed.devices, with_truth(viewed.estimators), with_truth(viewed.navigators),
              viewed.innovations),
      findings_(viewed.devices),
      integrity_(viewed.estimators),
      truth_(viewed.estimators.size()),
      last_sample_(viewed.devices.size()),
      last_attitude_(viewed.estimators.size() + 1),
      last_position_(viewed.estimators.size() + 1) {
  if (const auto error = server_.listen())
    throw std::runtime_error(
        fmt::format("cannot serve on {}:{}: {}", options_.address, options_.port, error.message()));
}

void RigViewer::add(std::vector<live::Service> services) {
  for (auto& service : services) server_.add_service(std::move(service));
}

std::string RigViewer::url() const {
  const auto token = options_.token.empty() ? "" : "?token=" + options_.token;
  return fmt::format("http://{}:{}/{}", options_.address, server_.port(), token);
}

bool RigViewer::due(Stamp& last, Stamp now) const {
  if (now >= last && now - last < shortest_interval) return false;
  last = now;
  return true;
}

void RigViewer::on_measurement(const measurement::Measurement& measurement) {
  look(measurement::origin_of(measurement).received_at);
  if (const auto* imu = std::get_if<measurement::ImuSample>(&measurement)) {
    const auto& origin = imu->origin;
    if (origin.device < last_sample_.size() && !due(last_sample_[origin.device], origin.valid_at))
      return;
  }
  topics_.publish(measurement);
}

void RigViewer::on_estimate(const Estimate& estimate) {
  show(estimate, estimate.estimator);
  if (const auto status = integrity_.take(estimate))
    topics_.publish({&*status, 1}, estimate.attitude.valid_at);
}

void RigViewer::show(const Estimate& estimate, std::size_t index) {
  if (due(last_attitude_.at(index), estimate.attitude.valid_at))
    topics_.publish(estimate.attitude, index);
  if (estimate.navigation && due(last_position_.at(index), estimate.navigation->valid_at))
    topics_.publish(*estimate.navigation, index);
}

void RigViewer::on_faults(std::span<const bus::Fault> faults, Stamp now) {
  faults_.assign(faults.begin(), faults.end());
  faults_told_ = now;
  topics_.publish(faults_, now);
}

void RigViewer::tick(Stamp now) {
  constexpr std::chrono::seconds again{1};
  if (!faults_.empty() && std::chrono::abs(now - faults_told_) >= again)
    on_faults(std::vector(faults_), now);
}

}  // namespace drydock::host
