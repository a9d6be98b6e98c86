#include "drivers/recordings/record/recover.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "drivers/recordings/mcap/writer.hpp"

namespace drydock::record {

namespace {

class Copy {
 public:
  explicit Copy(mcap::Sink sink) : sink_(std::move(sink)) {}

  void operator()(const mcap::Header& header) { begin(header); }
  void operator()(const mcap::DataEnd&) {}
  void operator()(const mcap::Channel& channel) {
    channels_.insert(channel.id);
    writer().add(channel);
  }
  void operator()(const mcap::Message& message) {
    if (!channels_.contains(message.channel)) {
      ++done_.nameless;
      return;
    }
    writer().add(message);
    const auto time = std::min(message.log_time, mcap::latest_time);
    if (done_.messages++ == 0) done_.first_time = time;
    done_.first_time = std::min(done_.first_time, time);
    done_.last_time = std::max(done_.last_time, time);
  }
  void operator()(const mcap::Attachment& attachment) {
    writer().add(attachment);
    ++done_.attachments;
  }
  void operator()(const auto& record) { writer().add(record); }

  Recovered finish(const std::string& damage) {
    done_.damage = damage;
    done_.error = writer().finish();
    return done_;
  }

 private:
  void begin(const mcap::Header& header) {
    if (!writer_) writer_.emplace(std::move(sink_), header);
  }
  mcap::Writer& writer() {
    begin({});
    return *writer_;
  }

  mcap::Sink sink_;
  std::optional<mcap::Writer> writer_;
  std::set<std::uint16_t> channels_;
  Recovered done_;
};

}  // namespace

Recovered recover(mcap::Reader& source, mcap::Sink sink, const std::function<bool()>& go_on) {
  Copy copy(std::move(sink));
  bool ended_early = false;
  while (const auto record = source.next()) {
    std::visit(copy, *record);
    ended_early = !go_on();
    if (ended_early) break;
  }
  auto done = copy.finish(source.damage());
  done.ended_early = ended_early;
  return done;
}

}  // namespace drydock::record
