#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "drivers/link/clock.hpp"
#include "hil/proxy/proxy.hpp"
#include "tests/drivers/link/running.hpp"
#include "tests/hil/proxy/outlet.hpp"

/// Real links in real time: these tests check a proxy's use of the operating system. Other tests
/// check the effects of faults in virtual time.
namespace drydock::proxy::testing {

using namespace link::testing;

/// A proxy between two URIs. The test holds both other ends.
class ProxyBetween {
 public:
  ProxyBetween(const std::string& real, const std::string& virt,
               const std::string& protocol = "nmea0183")
      : schedule(std::make_shared<fault::Schedule>(link::steady_now())) {
    ProxyOptions options;
    options.real = link::parse_uri(real).value();
    options.virt = link::parse_uri(virt).value();
    options.device.name = "device";
    options.device.protocol = protocol;
    options.device.link = real;
    options.schedule = schedule;
    options.say = [this](const std::string& line) { said.push_back(line); };
    proxy = Proxy::start(io, std::move(options));
  }
  ~ProxyBetween() {
    proxy->finish();
    io.restart();
    io.run_for(5s);
    EXPECT_TRUE(io.stopped()) << "a coroutine still waits";
  }

  bool until_said(const std::string& part, std::size_t times = 1) {
    return run_until(io, [&] {
      return static_cast<std::size_t>(std::ranges::count_if(said, [&](const auto& line) {
               return line.find(part) != std::string::npos;
             })) >= times;
    });
  }
  void set(const std::string& keys) {
    schedule->set(fault::testing::fault_of("device='device'\n" + keys), link::steady_now());
    proxy->rearm();
  }
  void clear() {
    schedule->clear();
    proxy->rearm();
  }

  boost::asio::io_context io{1};
  std::shared_ptr<fault::Schedule> schedule;
  std::vector<std::string> said;
  std::unique_ptr<Proxy> proxy;
};

inline std::string unique(const std::string& name) {
  return name + "-" + std::to_string(::getpid());
}

}  // namespace drydock::proxy::testing
