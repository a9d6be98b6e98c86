#include "drivers/cli/decode.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <memory>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/cli/json_lines.hpp"
#include "drivers/measurement/stamp.hpp"
#include "drivers/wire/candump.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::cli {

namespace {

/// The capture as blocks of bytes.
class Source {
 public:
  explicit Source(const std::string& file)
      : owned_(!file.empty() && file != "-"),
        fd_(owned_ ? ::open(file.c_str(), O_RDONLY | O_CLOEXEC) : STDIN_FILENO) {
    error_ = fd_ < 0 ? errno : 0;
  }
  ~Source() {
    if (owned_ && fd_ >= 0) ::close(fd_);
  }
  Source(const Source&) = delete;
  Source& operator=(const Source&) = delete;

  /// The next bytes, none at the end or after an error.
  wire::Bytes read() {
    if (error_) return {};
    ssize_t size = 0;
    do size = ::read(fd_, block_.data(), block_.size());
    while (size < 0 && errno == EINTR);
    if (size < 0) error_ = errno;
    return {block_.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))};
  }
  /// Whether the last read gave all that a read can give: more is likely to wait.
  bool likely_more(wire::Bytes last) const { return last.size() == block_.size(); }
  int error() const { return error_; }

 private:
  bool owned_;
  int fd_;
  int error_ = 0;
  std::vector<std::uint8_t> block_ = std::vector<std::uint8_t>(64 * 1024);
};

/// Where messages go: to lines, or to a count for each type.
class Sink {
 public:
  Sink(const DecodeOptions& options, std::FILE* out) : count_(options.count), lines_(out) {}

  template <class Variant>
  void message(const Variant& message) {
    put(message, [](JsonWriter&) {});
  }
  template <class Variant>
  void message(const Variant& message, const wire::candump::Line& line) {
    put(message, [&](JsonWriter& json) {
      json.field("time_s", measurement::seconds(line.time));
      json.field("interface", line.interface);
    });
  }
  bool flush() { return lines_.flush(); }

  /// The counts, if they are what was asked for.
  void finish() {
    for (const auto& entry : counts_)
      lines_.line([&](JsonWriter& json) {
        json.field("type", entry.first);
        json.field("count", entry.second);
      });
  }
  std::uint64_t messages() const { return messages_; }

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
          lines_.line([&](JsonWriter& json) {
            json.field("type", message.type);
            before(json);
            json.fields(message);
          });
        },
        any);
  }

  bool count_;
  JsonLines lines_;
  std::map<std::string_view, std::uint64_t> counts_;
  std::uint64_t messages_ = 0;
};

/// Reads to the end, cutting frames by `scan`; false when the output cannot be written.
template <std::size_t Capacity, class Scan, class OnFrame>
bool run(Source& source, Sink& sink, wire::Framer<Capacity>& framer, Scan&& scan,
         OnFrame&& on_frame, wire::StreamCounters& counters) {
  for (wire::Bytes bytes = source.read(); !bytes.empty(); bytes = source.read()) {
    framer.feed(bytes, scan, on_frame);
    if (!source.likely_more(bytes) && !sink.flush()) return false;  // a live line: show it now
  }
  const auto [total, frames] = std::pair(framer.counters().bytes_in, framer.counters().frames);
  constexpr std::uint8_t line_end[] = {'\n'};  // which the last line of a capture may lack
  if (framer.held() > 0) framer.feed(line_end, scan, on_frame);
  const bool lent = framer.counters().bytes_in > total && framer.counters().frames == frames;
  framer.finish(scan, on_frame);
  counters = framer.counters();
  counters.bytes_skipped -= lent;
  sink.finish();
  return sink.flush();
}

template <wire::ByteProtocol P>
bool decode_bytes(Source& source, Sink& sink, wire::StreamCounters& counters) {
  const auto framer = std::make_unique<wire::Framer<P::max_frame>>();
  return run(
      source, sink, *framer, P::scan,
      [&](wire::Bytes frame, std::size_t) {
        if (const auto message = P::decode(frame)) sink.message(*message);
      },
      counters);
}

template <wire::FrameProtocol P>
bool decode_frames(Source& source, Sink& sink, wire::StreamCounters& counters) {
  std::map<std::string, typename P::Decoder, std::less<>> buses;  // each assembles on its own
  wire::Framer<wire::Candump::max_frame> framer;
  const auto on_line = [&](wire::Bytes text, std::size_t) {
    const auto decoded = wire::Candump::decode(text);
    if (!decoded) return;
    const auto& line = std::get<wire::candump::Line>(*decoded);
    auto bus = buses.find(line.interface);
    if (bus == buses.end()) bus = buses.try_emplace(std::string(line.interface)).first;
    if (const auto message = bus->second.receive(line.frame)) sink.message(*message, line);
  };
  const bool written = run(source, sink, framer, wire::Candump::scan, on_line, counters);
  for (const auto& [name, decoder] : buses)
    counters.bad_checksums += decoder.counters().bad_checksums;
  return written;
}

template <class... P>
void append_names(wire::ProtocolList<P...>, std::string& names) {
  ((names += fmt::format("{}{}", names.empty() ? "" : ", ", P::name)), ...);
}

}  // namespace

std::string decode_protocols() {
  std::string names;
  append_names(wire::BytesProtocols{}, names);
  append_names(wire::FrameProtocols{}, names);
  append_names(wire::FrameCarriers{}, names);
  return names;
}

int decode(const DecodeOptions& options, std::FILE* out, std::FILE* err) {
  Source source(options.file);
  Sink sink(options, out);
  wire::StreamCounters counters;
  bool written = false;
  const auto bytes = [&]<class P>() { written = decode_bytes<P>(source, sink, counters); };
  const auto frames = [&]<class P>() { written = decode_frames<P>(source, sink, counters); };
  if (!wire::with_protocol(wire::BytesProtocols{}, options.protocol, bytes) &&
      !wire::with_protocol(wire::FrameCarriers{}, options.protocol, bytes) &&
      !wire::with_protocol(wire::FrameProtocols{}, options.protocol, frames)) {
    fmt::print(err, "decode: unknown protocol \"{}\", allowed: {}\n", options.protocol,
               decode_protocols());
    return 2;
  }
  if (source.error()) {
    fmt::print(err, "decode: cannot read {}: {}\n",
               options.file.empty() ? "standard input" : options.file,
               std::strerror(source.error()));
    return 2;
  }
  if (!written) {
    fmt::print(err, "decode: cannot write the output\n");
    return 2;
  }
  if (!options.quiet)
    fmt::print(err, "{} frames, {} messages, {} bad checksums, {} bytes skipped\n", counters.frames,
               sink.messages(), counters.bad_checksums, counters.bytes_skipped);
  return sink.messages() > 0 ? 0 : 1;
}

}  // namespace drydock::cli
