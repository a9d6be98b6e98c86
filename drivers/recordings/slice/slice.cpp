#include "drivers/recordings/slice/slice.hpp"

#include <algorithm>
#include <fstream>

#include "drivers/recordings/mcap/file_sink.hpp"
#include "drivers/recordings/mcap/writer.hpp"
#include "drivers/recordings/record/player.hpp"

namespace drydock::slice {

namespace {

using record::RecordingError;

Stamp log_time(const mcap::Message& message) {
  return measurement::stamp_from_ns(static_cast<std::int64_t>(message.log_time));
}

/// Processes the records of a recording in their order.
class Slicer {
 public:
  Slicer(const SliceOptions& options, const record::Recording& recording,
         const Disguise::Options& disguise, const std::optional<rig_config::Rig>& rig)
      : part_(options.part),
        recording_(recording),
        begin_(recording.begin().value_or(Stamp{})),
        disguise_(disguise, recording.links(), rig) {}

  /// Emits those records that are in the slice. The record's views are valid during the call.
  template <class Emit>
  void operator()(mcap::Record record, Emit& emit) {
    if (const auto* message = std::get_if<mcap::Message>(&record)) {
      if (taken_[message->channel] && part_.holds(log_time(*message), begin_))
        disguise_.apply(*message, std::ref(emit));
      return;
    }
    bool taken = true;
    if (auto* schema = std::get_if<mcap::Schema>(&record)) schemas_[schema->id] = *schema;
    if (auto* channel = std::get_if<mcap::Channel>(&record)) taken = takes(*channel);
    if (auto* attachment = std::get_if<mcap::Attachment>(&record))
      taken = disguise_.apply(*attachment);
    if (taken) std::visit(emit, record);
  }
  template <class Emit>
  void finish(Emit& emit) {
    disguise_.finish(std::ref(emit));
  }

  const Disguise& disguise() const { return disguise_; }

 private:
  bool takes(const mcap::Channel& channel) {
    const auto link = recording_.link_of(channel.id);
    disguise_.note(channel, schemas_[channel.schema], link);
    const bool taken = link ? part_.takes(recording_.links()[*link]) : part_.takes(channel);
    taken_[channel.id] = taken;
    return taken;
  }

  const record::Selection& part_;
  const record::Recording& recording_;
  Stamp begin_;
  Disguise disguise_;
  std::map<std::uint16_t, mcap::Schema> schemas_;
  std::map<std::uint16_t, bool> taken_;  ///< by channel
};

class Copy {
 public:
  Copy(mcap::Sink sink, Sliced& done) : sink_(std::move(sink)), done_(done) {}

  void operator()(const mcap::Header& header) {
    if (!writer_) writer_.emplace(std::move(sink_), header);
  }
  void operator()(const mcap::DataEnd&) {}
  void operator()(const mcap::Message& message) {
    error_ = writer().add(message);
    ++done_.messages;
    done_.first = std::min(done_.first.value_or(log_time(message)), log_time(message));
    done_.last = std::max(done_.last.value_or(log_time(message)), log_time(message));
  }
  void operator()(const auto& record) { writer().add(record); }

  boost::system::error_code error() const { return error_; }
  boost::system::error_code finish() { return writer().finish(); }

 private:
  mcap::Writer& writer() {
    (*this)(mcap::Header{});
    return *writer_;
  }

  mcap::Sink sink_;
  Sliced& done_;
  std::optional<mcap::Writer> writer_;
  boost::system::error_code error_;
};

mcap::Reader reader_of(const std::string& path) {
  return mcap::Reader(std::make_unique<std::ifstream>(path, std::ios::binary));
}

/// Attachments come before the slice's first position in the file, but need to know it.
std::optional<measurement::Geodetic> first_position(const std::string& path, Slicer slicer) {
  mcap::Reader reader = reader_of(path);
  constexpr auto nothing = [](const auto&) {};
  while (auto record = reader.next()) {
    slicer(std::move(*record), nothing);
    if (slicer.disguise().first_position()) break;
  }
  return slicer.disguise().first_position();
}

std::chrono::nanoseconds shift_of(const SliceOptions& options, Stamp begin) {
  if (!options.start_at) return options.shift_time;
  return *options.start_at - (begin + options.part.from.value_or(Stamp::duration{0}));
}

}  // namespace

boost::system::result<Sliced, RecordingError> slice(const std::string& path, const std::string& to,
                                                    const SliceOptions& options,
                                                    const record::Watch& watch) {
  const auto recording = record::Recording::open(path);
  if (!recording) return recording.error();
  if (auto misfit = record::misfit(options.part, *recording); !misfit.empty())
    return RecordingError{misfit};
  Sliced done;
  done.shift = shift_of(options, recording->begin().value_or(Stamp{}));
  const auto loaded = record::rig_of(*recording);
  const auto rig = loaded ? std::optional(*loaded) : std::nullopt;
  Disguise::Options disguise{done.shift, options.move_to, {}};
  if (options.move_to)
    disguise.first = first_position(path, Slicer(options, *recording, disguise, rig));

  auto sink = mcap::file_sink(to, options.overwrite);
  if (!sink) return RecordingError{mcap::refused(to, sink.error())};
  Slicer slicer(options, *recording, disguise, rig);
  Copy copy(std::move(*sink), done);
  mcap::Reader reader = reader_of(path);
  while (auto record = reader.next()) {
    slicer(std::move(*record), copy);
    if (copy.error()) break;
    done.ended_early = !watch(static_cast<double>(reader.position()) /
                              static_cast<double>(std::max<std::uint64_t>(reader.size(), 1)));
    if (done.ended_early) break;
  }
  slicer.finish(copy);
  if (const auto error = copy.finish()) return RecordingError{to + ": " + error.message()};
  done.moved = slicer.disguise().moved();
  done.dropped = slicer.disguise().dropped();
  done.damage = reader.damage();
  return done;
}

}  // namespace drydock::slice
