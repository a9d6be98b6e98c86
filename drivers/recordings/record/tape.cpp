#include "drivers/recordings/record/tape.hpp"

#include "drivers/recordings/mcap/writer.hpp"

namespace drydock::record {

namespace {

mcap::FileWriter start_file(mcap::Sink sink, const std::vector<mcap::Attachment>& attachments,
                            const std::vector<mcap::Metadata>& metadata) {
  mcap::FileWriter file(std::move(sink), {"ros2", "drydock " DRYDOCK_VERSION});
  for (const auto& attachment : attachments) file.write(attachment);
  for (const auto& entry : metadata) file.write(entry);
  return file;
}

}  // namespace

Tape::Tape(mcap::Sink sink, WhenBehind when_behind,
           const std::vector<mcap::Attachment>& attachments,
           const std::vector<mcap::Metadata>& metadata)
    : file_(start_file(std::move(sink), attachments, metadata)),
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

void Tape::put(std::uint32_t topic, Stamp at, std::span<const std::uint8_t> cdr) {
  const auto time = static_cast<std::uint64_t>(at.time_since_epoch().count());
  block_.add(
      mcap::Message{static_cast<std::uint16_t>(topic), sequences_[topic]++, time, time, cdr});
  if (mcap::is_full(block_)) put_block();
}

void Tape::tick(Stamp now) {
  const auto time = static_cast<std::uint64_t>(now.time_since_epoch().count());
  const auto oldest = block_.first_time() + static_cast<std::uint64_t>(mcap::block_time.count());
  const bool set_back =
      time + static_cast<std::uint64_t>(mcap::block_time.count()) < block_.first_time();
  if (block_.messages() > 0 && (time >= oldest || set_back)) put_block();
}

void Tape::put_block() {
  const auto messages = block_.messages();
  const bool taken =
      when_behind_ == WhenBehind::wait ? file_.put_when_there_is_room(block_) : file_.put(block_);
  if (taken) return;
  lost_ += messages;
  block_.clear();
}

boost::system::error_code Tape::finish() {
  put_block();
  return file_.finish({"recording", {{"messages_lost", std::to_string(lost_)}}});
}

TapeStatus Tape::status() const {
  const auto file = file_.progress();
  return {file.messages, file.lost + lost_, file.size, file.error};
}

}  // namespace drydock::record
