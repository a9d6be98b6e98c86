#include "drivers/record/tape.hpp"

#include "drivers/bus/schema.hpp"
#include "drivers/mcap/writer.hpp"

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

std::uint16_t Tape::add_channel(const std::string& topic, const std::string& type,
                                mcap::Map metadata) {
  const auto next = static_cast<std::uint16_t>(schemas_.size() + 1);
  const auto [schema, is_new] = schemas_.emplace(type, next);
  if (is_new) block_.add(mcap::Schema{schema->second, type, "ros2msg", bus::ros2_schema(type)});
  const auto id = static_cast<std::uint16_t>(sequences_.size());
  sequences_.push_back(0);
  block_.add(mcap::Channel{id, schema->second, topic, "cdr", std::move(metadata)});
  return id;
}

void Tape::begin() { put(); }

void Tape::add(std::uint16_t channel, Stamp at, mcap::Bytes data) {
  const auto time = static_cast<std::uint64_t>(at.time_since_epoch().count());
  block_.add(mcap::Message{channel, sequences_[channel]++, time, time, data});
  if (mcap::is_full(block_)) put();
}

void Tape::tick(Stamp now) {
  const auto time = static_cast<std::uint64_t>(now.time_since_epoch().count());
  const auto oldest = block_.first_time() + static_cast<std::uint64_t>(mcap::block_time.count());
  if (block_.messages() > 0 && time >= oldest) put();
}

void Tape::put() {
  const auto messages = block_.messages();
  const bool taken =
      when_behind_ == WhenBehind::wait ? file_.put_when_there_is_room(block_) : file_.put(block_);
  if (taken) return;
  lost_ += messages;
  block_.clear();
}

boost::system::error_code Tape::finish() {
  put();
  return file_.finish({"recording", {{"messages_lost", std::to_string(lost_)}}});
}

TapeStatus Tape::status() const {
  const auto file = file_.progress();
  return {file.messages, file.lost + lost_, file.size, file.error};
}

}  // namespace drydock::record
