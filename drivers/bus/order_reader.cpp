#include "drivers/bus/order_reader.hpp"

#include "drivers/bus/convert/convert_order.hpp"
#include "drivers/bus/reader.hpp"

namespace drydock::bus {

struct OrderReader::Readers {
  explicit Readers(const Participant& participant)
      : joints(participant, joint_orders_topic, doorbell),
        wrench(participant, wrench_orders_topic, doorbell) {}

  Doorbell doorbell;
  Reader<JointStateMessage> joints;
  Reader<WrenchMessage> wrench;
  std::uint64_t unusable = 0;
};

OrderReader::OrderReader(const Participant& participant)
    : readers_(std::make_unique<Readers>(participant)) {}
OrderReader::~OrderReader() = default;

void OrderReader::take(const OnJoints& on_joints, const OnWrench& on_wrench) {
  readers_->doorbell.silence();
  readers_->joints.drain([&](const JointStateMessage& message, const dds_sample_info_t&) {
    std::vector<measurement::JointOrder> orders;
    read(orders, message) ? on_joints(orders) : static_cast<void>(++readers_->unusable);
  });
  readers_->wrench.drain([&](const WrenchMessage& message, const dds_sample_info_t&) {
    measurement::BodyWrench wrench;
    read(wrench, message) ? on_wrench(wrench) : static_cast<void>(++readers_->unusable);
  });
}

std::size_t OrderReader::matched_writers() const {
  return readers_->joints.matched() + readers_->wrench.matched();
}
std::uint64_t OrderReader::unusable() const { return readers_->unusable; }

}  // namespace drydock::bus
