#include "drivers/shell/real_time.hpp"

#include <algorithm>
#include <utility>

#include "drivers/shell/bus_line.hpp"
#include "drivers/shell/byte_line.hpp"

namespace drydock::shell {
namespace {

std::unique_ptr<Line> make_line(boost::asio::io_context& io, const link::Uri& uri, RawListener* raw,
                                bool is_bus) {
  if (is_bus) return std::make_unique<BusLine>(io, uri, raw);
  return std::make_unique<ByteLine>(io, uri, raw);
}

}  // namespace

RealTime::RealTime(boost::asio::io_context& io,
                   std::vector<std::unique_ptr<device::Device>> devices, device::Listener& listener,
                   RawListener* raw)
    : devices_(std::move(devices)) {
  for (const auto& device : devices_) {
    const link::Uri uri = link::parse_uri(device->options().link).value();
    auto line =
        std::ranges::find_if(lines_, [&](const auto& one) { return one->uri().text == uri.text; });
    if (line == lines_.end()) {
      line = lines_.insert(lines_.end(), make_line(io, uri, raw, device->on_bus()));
    }
    (*line)->add(*device, listener);
  }
}

RealTime::~RealTime() = default;

void RealTime::start() {
  for (const auto& line : lines_) line->start();
}

void RealTime::stop() {
  for (const auto& line : lines_) line->stop();
}

void RealTime::send(std::string_view link, const wire::CanFrame& frame) {
  for (const auto& line : lines_)
    if (line->uri().text == link) line->transmit(frame);
}

device::Health RealTime::health(std::size_t i) const { return devices_[i]->health(link::now()); }

}  // namespace drydock::shell
