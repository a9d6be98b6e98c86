#include "drivers/shell/receiver_date.hpp"

#include "drivers/capture/line_file.hpp"
#include "drivers/device/make_driver.hpp"

namespace drydock::shell {
namespace {

/// Hears the first fix with UTC.
class DateEar final : public device::Output {
 public:
  void publish(const device::Measurement& measurement) override {
    const auto* fix = std::get_if<measurement::GnssFix>(&measurement);
    if (fix == nullptr || !fix->utc || date_) return;
    date_ = std::chrono::round<std::chrono::days>(*fix->utc - fix->origin.received_at);
  }
  void send(wire::Bytes) override {}
  void send(const wire::CanFrame&) override {}
  const std::optional<std::chrono::nanoseconds>& date() const { return date_; }

 private:
  std::optional<std::chrono::nanoseconds> date_;
};

}  // namespace

std::optional<std::chrono::nanoseconds> date_by_receiver(const link::Uri& uri) {
  device::DriverOptions receiver;
  receiver.kind = device::Kind::gnss;
  receiver.protocol = "nmea0183";  // a logger's stamps are known around its sentences alone
  const auto driver = device::make_byte_driver(receiver);
  if (!driver) return {};
  DateEar ear;
  capture::LineFile line(uri.target, false, std::string(uri.text_of("interface")));
  while (const auto read = line.next()) {
    if (read->time) (*driver)->receive(read->bytes, measurement::Stamp{*read->time}, ear);
    if (ear.date()) break;
  }
  (*driver)->finish(ear);
  return ear.date();
}

}  // namespace drydock::shell
