#include "drivers/recordings/record/tape.hpp"

#include "drivers/recordings/mcap/writer.hpp"

namespace drydock::record {

Tape::Tape(Parts parts, WhenBehind when_behind, std::vector<mcap::Attachment> attachments,
           std::vector<mcap::Metadata> metadata)
    : file_(FileSeries(
          std::move(parts),
          {{"ros2", "drydock " DRYDOCK_VERSION}, std::move(attachments), std::move(metadata)})),
      when_behind_(when_behind),
      sequences_(1) {}

std::uint32_t Tape::add_topic(const Topic& topic) {
  const auto next = static_cast<std::uint16_t>(schemas_.size() + 1);
  const auto [schema, is_new] = schemas_.emplace(topic.type, next);
  if (is_new) block_.add(mcap::Schema{schema->second, topic.type, "ros2msg", topic.schema});
  const auto id = static_cast<std::uint16_t>(sequences_.size());
  sequences_.push_back(0);
  block_.add(mcap::Channel{id, schema->second, topic.name, "cdr", topic.metadata});
  return id;
}

void Tape::begin() { put_block(); }

void Tape::write(std::uint32_t topic, std::chrono::nanoseconds at,
                 std::span<const std::uint8_t> cdr) {
  const auto time = static_cast<std::uint64_t>(at.count());
  block_.add(
      mcap::Message{static_cast<std::uint16_t>(topic), sequences_[topic]++, time, time, cdr});
  if (mcap::is_full(block_)) put_block();
}

void Tape::tick(Stamp now) {
  const auto time = static_cast<std::uint64_t>(times_.beside(now.time_since_epoch()).count());
  const auto oldest = block_.first_time() + static_cast<std::uint64_t>(mcap::block_time.count());
  const bool set_back =
      time + static_cast<std::uint64_t>(mcap::block_time.count()) < block_.first_time();
  if (block_.messages() > 0 && (time >= oldest || set_back)) put_block();
}

void Tape::put_block() {
  const bool taken =
      when_behind_ == WhenBehind::wait ? file_.put_when_there_is_room(block_) : file_.put(block_);
  if (!taken) block_.clear();
}

boost::system::error_code Tape::finish() {
  put_block();
  return file_.finish();
}

TapeStatus Tape::status() const {
  const auto file = file_.progress();
  return {file.messages, file.lost,  file.size,       file.files,
          file.deleted,  file.error, file.failed_file};
}

}  // namespace drydock::record
