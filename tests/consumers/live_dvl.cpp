#include <drydock/drivers/shell/real_time.hpp>
#include <iostream>

using namespace drydock;

struct Printer : device::Listener {
  boost::asio::io_context& io;
  explicit Printer(boost::asio::io_context& context) : io(context) {}
  void on_measurement(const device::Measurement& measurement) override {
    const auto& dvl = std::get<measurement::BottomVelocity>(measurement);
    if (dvl.velocity) std::cout << dvl.velocity->transpose() << std::endl;
  }
  void on_state(const device::Device& device, const device::Transition&) override {
    std::cerr << device.name() << ": " << to_string(device.state()) << "\n";
    if (device.state() == device::State::backing_off) io.stop();
  }
};

int main(int, char** argv) {
  boost::asio::io_context io;
  Printer printer(io);
  device::DeviceOptions options{.name = "dvl", .link = argv[1], .nominal_rate_hz = 5};
  options.driver.kind = device::Kind::dvl;
  options.driver.protocol = "pd0";
  std::vector<std::unique_ptr<device::Device>> devices;
  devices.push_back(device::Device::make(options).value());  // throws if no driver speaks so
  shell::RealTime shell(io, std::move(devices), printer);
  shell.start();
  io.run();
}
