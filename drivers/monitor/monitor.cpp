#include "drivers/monitor/monitor.hpp"

#include <fmt/format.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdio>
#include <functional>
#include <memory>

#include "drivers/decode/decode.hpp"
#include "drivers/device/timed_framer.hpp"
#include "drivers/io/until_stopped.hpp"
#include "drivers/link/reading.hpp"
#include "drivers/monitor/monitor_wire.hpp"
#include "drivers/monitor/places_cursor.hpp"
#include "drivers/probe/typed_link.hpp"
#include "drivers/terminal/exit_codes.hpp"
#include "drivers/text/json_lines.hpp"
#include "drivers/wire/described/described_codec.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::monitor {
namespace {

namespace asio = boost::asio;
using measurement::Stamp;

constexpr std::chrono::seconds counters_period{2};

/// Decodes the data from the link and prints them.
class Screen {
 public:
  virtual ~Screen() = default;
  virtual void receive(wire::Bytes, Stamp) {}
  virtual void receive(const wire::CanFrame&, Stamp) {}
  virtual void finish() {}  ///< no more bytes will come
  virtual const wire::StreamCounters& counters() const = 0;
  std::uint64_t messages() const { return messages_; }

 protected:
  template <class Variant>
  void print(const Variant& any, Stamp received_at) {
    ++messages_;
    std::visit(
        [&](const auto& message) {
          lines_.line([&](text::JsonWriter& json) {
            json.field("type", message.type);
            json.field("received_at_s", measurement::seconds(received_at.time_since_epoch()));
            json.fields(message);
          });
        },
        any);
    lines_.flush();
    std::fflush(stdout);
  }

 private:
  text::JsonLines lines_{stdout};
  std::uint64_t messages_ = 0;
};

/// `Codec`: one of the registry, or DescribedCodec.
template <class Codec>
class ByteScreen final : public Screen {
 public:
  explicit ByteScreen(Codec codec) : codec_(std::move(codec)) {}
  using Screen::receive;
  void receive(wire::Bytes bytes, Stamp at) override { framer_.feed(bytes, at, scan(), printer()); }
  void finish() override { framer_.finish(scan(), printer()); }
  const wire::StreamCounters& counters() const override { return framer_.counters(); }

 private:
  auto scan() const {
    return [this](wire::Bytes all) { return codec_.scan(all); };
  }
  auto printer() {
    return [this](wire::Bytes frame, const device::Arrival& arrival) {
      if (const auto message = codec_.decode(frame)) print(*message, arrival.read_at);
    };
  }

  Codec codec_;
  device::TimedFramer<Codec::max_frame> framer_;
};

/// `Decoder`: that of a protocol of the registry, or FrameDecoder.
template <class Decoder>
class FrameScreen final : public Screen {
 public:
  explicit FrameScreen(Decoder decoder) : decoder_(std::move(decoder)) {}
  using Screen::receive;
  void receive(const wire::CanFrame& frame, Stamp at) override {
    if (const auto message = wire::receive_at(decoder_, frame, at.time_since_epoch()))
      print(*message, at);
  }
  const wire::StreamCounters& counters() const override { return decoder_.counters(); }

 private:
  Decoder decoder_;
};

std::unique_ptr<Screen> described_screen(const wire::described::DescriptionPtr& description,
                                         link::Carries carries) {
  using wire::described::DescribedCodec;
  using wire::described::FrameDecoder;
  const bool on_bus = description->frames != nullptr;
  if (on_bus != (carries == link::Carries::frames)) return nullptr;
  if (on_bus) return std::make_unique<FrameScreen<FrameDecoder>>(FrameDecoder(description));
  return std::make_unique<ByteScreen<DescribedCodec>>(DescribedCodec(description));
}

std::unique_ptr<Screen> make_screen(const MonitorOptions& options, link::Carries carries) {
  if (options.description) return described_screen(options.description, carries);
  std::unique_ptr<Screen> screen;
  if (carries == link::Carries::bytes) {
    wire::with_protocol(wire::BytesProtocols{}, options.protocol,
                        [&]<class P>() { screen = std::make_unique<ByteScreen<P>>(P{}); });
  } else {
    const auto make = [&]<class P>() {
      using Decoder = typename P::Decoder;
      screen = std::make_unique<FrameScreen<Decoder>>(Decoder{});
    };
    wire::with_protocol(wire::FrameProtocols{}, options.protocol, make);
    wire::with_protocol(wire::FramesAsTheyAre{}, options.protocol, make);
  }
  return screen;
}

void print_counters(const Screen& screen) {
  const auto& c = screen.counters();
  fmt::print(stderr, "{} messages, {} bytes, {} in good frames, {} skipped, {} bad checksums\n",
             screen.messages(), c.bytes_in, c.bytes_good, c.bytes_skipped, c.bad_checksums);
}

/// The same link, which nothing disturbs. Where nobody says the rate of an slcan adapter's bus, it
/// is found by listening.
link::Uri only_heard(const link::Uri& uri) {
  auto heard = link::listening(uri);
  if (uri.scheme == link::Scheme::slcan && uri.text_of("bitrate").empty())
    heard.query["bitrate"] = "auto";
  return heard;
}

/// Listens until the duration is over, Ctrl-C, or the end of the link.
template <class Link>
int watch(asio::io_context& io, Link& open_link, Screen& screen, double duration_s) {
  asio::steady_timer every(io);
  bool stopped = false;  // an expired timer can no longer be cancelled
  io::UntilStopped until(io, duration_s, [&] {
    stopped = true;
    every.cancel();
    open_link.close();
  });
  std::function<void()> tell = [&] {
    every.expires_after(counters_period);
    every.async_wait([&](const boost::system::error_code& ec) {
      if (ec || stopped) return;
      print_counters(screen);
      if (screen.messages() == 0 && !open_link.note().empty())
        fmt::print(stderr, "{}\n", open_link.note());
      tell();
    });
  };
  tell();
  asio::co_spawn(io,
                 link::read_until_lost<Link>(
                     open_link, [&](const auto& item, Stamp at) { screen.receive(item, at); }),
                 [&](const std::exception_ptr&, const boost::system::error_code& why) {
                   if (why != asio::error::operation_aborted)
                     fmt::print(stderr, "the {} ended: {}\n",
                                std::is_same_v<Link, link::ByteLink> ? "link" : "bus",
                                why.message());
                   until.stop();
                 });
  io.run();
  screen.finish();
  print_counters(screen);
  if (!open_link.note().empty()) fmt::print(stderr, "{}\n", open_link.note());
  return terminal::exit_of(screen.messages() > 0);
}

}  // namespace

int monitor_messages(const MonitorOptions& options) {
  const auto uri = link::parse_uri(probe::typed_link(options.link));
  if (!uri) {
    fmt::print(stderr, "monitor: {}\n", uri.error().message);
    return terminal::exit_usage;
  }
  auto carries = uri->carries();
  auto screen = make_screen(options, carries);
  if (!screen && uri->recorded()) {
    carries = link::Carries::frames;
    screen = make_screen(options, carries);
  }
  if (!screen) {
    const bool bytes = uri->carries() == link::Carries::bytes;
    fmt::print(stderr, "monitor: a {} link carries no protocol \"{}\"; allowed: {}\n",
               bytes ? "byte" : "CAN", options.protocol,
               uri->recorded() ? decode::decode_protocols()
               : bytes         ? decode::byte_protocols()
                               : decode::frame_protocols());
    return terminal::exit_usage;
  }
  const auto heard = only_heard(*uri);
  if (places_cursor()) return monitor_wire(options, heard, carries);
  asio::io_context io{1};
  const auto watch_opened = [&](auto opened) {
    if (opened) return watch(io, **opened, *screen, options.duration_s);
    fmt::print(stderr, "monitor: {}\n", opened.error().message);
    return terminal::exit_usage;
  };
  return carries == link::Carries::bytes
             ? watch_opened(link::open_bytes(io.get_executor(), heard, link::Side::driver))
             : watch_opened(link::open_frames(io.get_executor(), heard, link::Side::driver));
}

}  // namespace drydock::monitor
