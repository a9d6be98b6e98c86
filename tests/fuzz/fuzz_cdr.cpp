#include <cmath>
#include <cstdlib>
#include <vector>

#include "drivers/bus/cdr/cdr_measurements.hpp"
#include "drivers/bus/cdr/cdr_publisher.hpp"
#include "drivers/measurement/measurement.hpp"

using namespace drydock;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// Keeps the message of the topic that loses no field.
class OneTopic final : public bus::CdrSink {
 public:
  std::uint32_t add_topic(const Topic& topic) override {
    wanted_.push_back(bus::measurement_topic(topic.name, topic.type).has_value());
    return static_cast<std::uint32_t>(wanted_.size() - 1);
  }
  bool wanted(std::uint32_t topic) const override { return wanted_[topic]; }
  void put(std::uint32_t, measurement::Stamp, std::span<const std::uint8_t> cdr) override {
    bytes.assign(cdr.begin(), cdr.end());
  }

  std::vector<std::uint8_t> bytes;

 private:
  std::vector<bool> wanted_;
};

}  // namespace

/// Decodes any bytes as the message of a kind of device. The result is nothing, or a measurement.
/// Encoding that measurement gives the same bytes, so no part of it was invented.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto kind = static_cast<bus::Kind>(data[0] % 6);
  std::vector<std::uint8_t> cdr{0, 1, 0, 0};
  cdr.insert(cdr.end(), data + 1, data + size);
  if ((data[0] & 0x80) != 0) cdr.erase(cdr.begin(), cdr.begin() + 4);
  bus::CdrMeasurements in;
  const auto first = in.read(kind, cdr, {});
  if (!first) return 0;
  OneTopic sink;
  bus::CdrPublisher out(sink, {{"d", kind}}, {});
  out.publish(*first);
  require(!sink.bytes.empty());
  const auto sent = sink.bytes;
  const auto second = in.read(kind, sent, {});
  require(second.has_value());
  out.publish(*second);
  require(sink.bytes == sent);
  return 0;
}
