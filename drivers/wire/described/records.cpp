#include "drivers/wire/described/records.hpp"

#include "drivers/wire/described/codec.hpp"

namespace drydock::wire::described {

void unread_records(const Plan& plan, Bytes frame,
                    const std::function<void(std::uint16_t)>& unread) {
  const auto has_records = [](const Message& message) { return message.records.has_value(); };
  if (std::ranges::none_of(plan.messages, has_records)) return;
  Record record;
  if (decode(plan, frame, record) != Decoded::message || !has_records(*record.message)) return;
  Packet packet;
  const bool stuffed = plan.stuffing != Stuffing::none;
  if (stuffed && !unstuff(plan.stuffing, frame, packet)) return;
  const Bytes whole = stuffed ? Bytes(packet) : frame;
  const auto fields = plan.fields_of(*record.message);
  for_each_record(*record.message->records, whole.first(whole.size() - plan.tail()),
                  [&](std::uint16_t id, Bytes) {
                    if (std::ranges::find(fields, id, &Field::record) == fields.end()) unread(id);
                  });
}

}  // namespace drydock::wire::described
