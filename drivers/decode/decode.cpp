#include "drivers/decode/decode.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/capture/file_blocks.hpp"
#include "drivers/capture/frame_capture.hpp"
#include "drivers/capture/line_file.hpp"
#include "drivers/decode/decode_by_dbc.hpp"
#include "drivers/decode/decode_by_pgns.hpp"
#include "drivers/decode/records.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/terminal/interrupt_flag.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/wire/described/described_codec.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "drivers/wire/passed_over.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::decode {

namespace {

using capture::FileBlocks;
using capture::FrameCapture;
using capture::LineFile;

constexpr std::string_view raw_format = "raw";

/// CAN captures, one behind the other.
struct FrameFiles {
  FileBlocks blocks;
  FrameCapture capture;
  FollowingTimes times{};
};

/// Receives the messages: prints them as lines, or counts them by type.
class Sink {
 public:
  Sink(const DecodeOptions& options, std::FILE* out) : count_(options.count), lines_(out) {}

  template <class Variant>
  void message(const Variant& message) {
    put(message, [](text::JsonWriter&) {});
  }
  template <class Variant>
  void message(const Variant& message, const capture::Record& record) {
    put(message, [&](text::JsonWriter& json) { put_record(json, record); });
  }
  void passed_over(const std::string& name) { ++passed_over_[name]; }
  bool flush() { return lines_.flush(); }

  /// Prints the counts if counts were asked for.
  void finish() {
    for (const auto& entry : counts_)
      lines_.line([&](text::JsonWriter& json) {
        json.field("type", entry.first);
        json.field("count", entry.second);
      });
  }
  std::uint64_t messages() const { return messages_; }
  /// How many frames, or blocks of frames, were valid but not read, by name.
  const std::map<std::string, std::uint64_t>& passed_over() const { return passed_over_; }

 private:
  template <class Variant, class Before>
  void put(const Variant& any, Before&& before) {
    ++messages_;
    std::visit(
        [&](const auto& message) {
          if (count_) {
            ++counts_[message.type];
            return;
          }
          lines_.line([&](text::JsonWriter& json) {
            json.field("type", message.type);
            before(json);
            json.fields(message);
          });
        },
        any);
  }

  bool count_;
  text::JsonLines lines_;
  std::map<std::string_view, std::uint64_t> counts_;
  std::map<std::string, std::uint64_t> passed_over_;
  std::uint64_t messages_ = 0;
};

/// Decodes a byte capture to its end. False if the output cannot be written.
template <class Codec>
bool decode_bytes(const Codec& codec, LineFile& line, Sink& sink, wire::StreamCounters& counters) {
  const auto framer = std::make_unique<wire::Framer<Codec::max_frame>>();
  const auto scan = [&](wire::Bytes bytes) { return codec.scan(bytes); };
  const auto on_frame = [&](wire::Bytes frame, std::size_t) {
    const auto message = codec.decode(frame);
    if (message) sink.message(*message);
    wire::tell_passed_over(codec, frame, message.has_value(),
                           [&](const std::string& name) { sink.passed_over(name); });
  };
  while (const auto read = line.next()) {
    framer->feed(read->bytes, scan, on_frame);
    if (!line.likely_more(read->bytes) && !sink.flush()) return false;  // a live input: show it now
  }
  const auto [total, frames] = std::pair(framer->counters().bytes_in, framer->counters().frames);
  constexpr std::uint8_t line_end[] = {'\n'};  // the last line of a capture may have no end
  if (framer->held() > 0) framer->feed(line_end, scan, on_frame);
  const bool lent = framer->counters().bytes_in > total && framer->counters().frames == frames;
  framer->finish(scan, on_frame);
  counters = framer->counters();
  counters.bytes_skipped -= lent;
  sink.finish();
  return sink.flush();
}

template <wire::FrameProtocol P>
wire::Network network_of() {
  const wire::Protocol* facts = wire::find_protocol(P::name);
  return facts != nullptr ? facts->network : wire::Network::none;
}

/// A decoder counts only frames of its own messages. So one that changes no counter is passed over.
template <class Decoder>
void receive(Decoder& decoder, const capture::Record& record, wire::Network network, Sink& sink) {
  const wire::StreamCounters before = decoder.counters();
  if (const auto message =
          wire::receive_at(decoder, record.frame, record.time.value_or(std::chrono::nanoseconds{})))
    sink.message(*message, record);
  else if (decoder.counters() == before)
    sink.passed_over(wire::frame_name_of<Decoder>(record.frame, network));
}

/// Decodes a CAN capture to its end. `make` gives a decoder for each bus: it assembles its own.
/// False if the output cannot be written.
template <class Make>
bool decode_frames(const Make& make, wire::Network network, FrameFiles& files, Sink& sink,
                   wire::StreamCounters& counters) {
  std::map<std::string, decltype(make()), std::less<>> buses;
  const auto on_record = [&](const capture::Record& record) {
    auto bus = buses.find(record.interface);
    if (bus == buses.end()) bus = buses.emplace(std::string(record.interface), make()).first;
    receive(bus->second, record, network, sink);
  };
  auto& [blocks, frames, times] = files;
  if (!read_records(blocks, frames, times, on_record, [&] { return sink.flush(); })) return false;
  for (auto& bus : buses) {
    auto& decoder = bus.second;
    if constexpr (requires { decoder.finish(); }) decoder.finish();
    counters.bad_checksums += decoder.counters().bad_checksums;
  }
  counters.frames = frames.tally().frames;
  counters.bytes_skipped = frames.tally().bytes_skipped;
  sink.finish();
  return sink.flush();
}

/// Decodes with a description, whichever way its sensor talks.
bool decode_described(const wire::described::DescriptionPtr& description, LineFile& line,
                      FrameFiles& files, Sink& sink, wire::StreamCounters& counters) {
  if (!description->frames)
    return decode_bytes(wire::described::DescribedCodec(description), line, sink, counters);
  const auto make = [&] { return wire::described::FrameDecoder(description); };
  return decode_frames(make, description->facts.network, files, sink, counters);
}

template <class... P>
void append_names(wire::ProtocolList<P...>, std::string& names) {
  ((names += fmt::format("{}{}", names.empty() ? "" : ", ", P::name)), ...);
}

/// True if the list has a protocol of that name.
template <class List>
bool knows(List list, std::string_view name) {
  return wire::with_protocol(list, name, []<class P>() {});
}

void print_totals(std::FILE* err, const wire::StreamCounters& counters, std::uint64_t messages,
                  const FrameCapture& capture) {
  if (capture.format() != nullptr) fmt::print(err, "{}: ", capture.format()->name);
  fmt::print(err, "{} frames, {} messages, {} bad checksums, {} bytes skipped\n", counters.frames,
             messages, counters.bad_checksums, counters.bytes_skipped);
  const std::string damage = capture::damage_text(capture.tally());
  if (!damage.empty()) fmt::print(err, "{}\n", damage);
}

void print_passed_over(std::FILE* err, const Sink& sink) {
  if (sink.passed_over().empty()) return;
  fmt::print(err, "passed over:\n");
  for (const auto& [name, count] : sink.passed_over()) fmt::print(err, "{:>8}  {}\n", count, name);
}

}  // namespace

std::string byte_protocols() {
  std::string names;
  append_names(wire::BytesProtocols{}, names);
  return names;
}

std::string frame_protocols() {
  std::string names;
  append_names(wire::FrameProtocols{}, names);
  append_names(wire::FramesAsTheyAre{}, names);
  return names;
}

std::string decode_protocols() {
  std::string names = byte_protocols() + ", " + frame_protocols();
  append_names(wire::FrameCarriers{}, names);
  return names;
}

std::string decode_formats() { return fmt::format("{}, {}", raw_format, capture::format_names()); }

int decode(const DecodeOptions& options, std::FILE* out, std::FILE* err) {
  if (!options.dbc.empty()) return decode_by_dbc(options, out, err);
  if (!options.pgns.empty()) return decode_by_pgns(options, out, err);
  const std::string& protocol = options.protocol;
  if (protocol.empty())
    return refuse(err,
                  "--protocol, --dbc or --pgns is missing; drydock probe FILE finds the protocol");
  const bool from_frames = knows(wire::FrameProtocols{}, protocol) ||
                           knows(wire::FramesAsTheyAre{}, protocol) ||
                           (options.description && options.description->frames);
  if (!from_frames && !options.description && !knows(wire::BytesProtocols{}, protocol) &&
      !knows(wire::FrameCarriers{}, protocol)) {
    return refuse(
        err, fmt::format("unknown protocol \"{}\", allowed: {}", protocol, decode_protocols()));
  }
  const capture::Format* format = from_frames ? capture::find_format(options.format) : nullptr;
  const bool raw = !from_frames && options.format == raw_format;
  if (!options.format.empty() && format == nullptr && !raw) {
    return refuse(err, fmt::format("no format \"{}\" with protocol {}, allowed: {}", options.format,
                                   protocol, from_frames ? capture::format_names() : raw_format));
  }

  const auto names = files_of(options);
  FrameFiles files{FileBlocks(from_frames ? names : std::vector{names.front()}),
                   FrameCapture(format)};
  auto& [blocks, capture, times] = files;
  LineFile line(names, raw, options.interface);
  const terminal::InterruptFlag interrupt;  // what came before a signal is counted at the end
  blocks.end_when([&] { return interrupt.set(); });
  line.end_when([&] { return interrupt.set(); });
  Sink sink(options, out);
  wire::StreamCounters counters;
  bool written = false;
  const auto bytes = [&]<class P>() { written = decode_bytes(P{}, line, sink, counters); };
  const auto frames = [&]<class P>() {
    const auto make = [] { return typename P::Decoder{}; };
    written = decode_frames(make, network_of<P>(), files, sink, counters);
  };
  if (options.description)
    written = decode_described(options.description, line, files, sink, counters);
  wire::with_protocol(wire::BytesProtocols{}, protocol, bytes);
  wire::with_protocol(wire::FrameCarriers{}, protocol, bytes);
  wire::with_protocol(wire::FrameProtocols{}, protocol, frames);
  wire::with_protocol(wire::FramesAsTheyAre{}, protocol, frames);

  if (blocks.error() != 0) {
    return refuse(err, cannot_read(blocks.file(), blocks.error()), terminal::exit_failed);
  }
  if (!from_frames && !line.trouble().empty())
    return refuse(err, line.trouble(), terminal::exit_failed);
  if (capture.unknown())
    return refuse(err, capture::unknown_format_text(name_of(options), capture),
                  terminal::exit_failed);
  if (!written) return refuse(err, "cannot write the output", terminal::exit_failed);
  if (!options.quiet) {
    if (const auto note = line.note(); !note.empty()) fmt::print(err, "{}\n", note);
    print_totals(err, counters, sink.messages(), capture);
    for (const auto& damage : {line.damage(), line.cut_note()})
      if (!damage.empty()) fmt::print(err, "{}\n", damage);
    print_notes(err, times);
    print_passed_over(err, sink);
  }
  return terminal::exit_of(sink.messages() > 0);
}

}  // namespace drydock::decode
