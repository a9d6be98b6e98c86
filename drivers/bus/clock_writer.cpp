#include "drivers/bus/clock_writer.hpp"

#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/endpoint.hpp"

namespace drydock::bus {

namespace {

constexpr std::int32_t clock_depth = 10;

}  // namespace

ClockWriter::ClockWriter(const Participant& participant)
    : topic_(make_topic<ClockMessage>(participant.handle(), "rt/clock")),
      writer_(dds_create_writer(participant.handle(), topic_.handle(),
                                make_qos(clock_depth, 0, user_data<ClockMessage>()).get(), nullptr),
              "writer of rt/clock") {}

void ClockWriter::write(measurement::Stamp now) {
  const ClockMessage message{to_time(now)};
  dds_write_ts(writer_.handle(), &message, now.time_since_epoch().count());
}

std::size_t ClockWriter::matched_readers() const {
  dds_publication_matched_status_t status{};
  dds_get_publication_matched_status(writer_.handle(), &status);
  return status.current_count;
}

}  // namespace drydock::bus
