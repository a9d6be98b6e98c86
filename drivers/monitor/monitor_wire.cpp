#include "drivers/monitor/monitor_wire.hpp"

#include <fmt/format.h>

#include <boost/asio/co_spawn.hpp>
#include <functional>

#include "drivers/link/clock.hpp"
#include "drivers/link/reading.hpp"
#include "drivers/monitor/frames/wire_watch.hpp"
#include "drivers/monitor/monitor_loop.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::monitor {
namespace {

namespace asio = boost::asio;

constexpr double quiet_after_s = 2;

std::unique_ptr<WireWatch> watch_of(const MonitorOptions& options, link::Carries carries) {
  if (carries == link::Carries::bytes) return watch_bytes(options.protocol, options.description);
  auto bus = watch_bus();
  bus->add(options.protocol, options.description);
  return bus;
}

/// A wire in the place of a device.
class WireView {
 public:
  WireView(const MonitorOptions& options, link::Carries carries)
      : watch(watch_of(options, carries)) {
    view_.name = view_.link = options.link;
    view_.protocol = options.protocol;
    view_.kind = carries == link::Carries::bytes ? "bytes of" : "frames of";
    view_.state = "waiting";
  }

  template <class Item>
  void receive(const Item& item, measurement::Stamp at) {
    watch->receive(item, at);
    ++view_.messages;
    last_ = link::steady_now();
  }
  void ended(const std::string& why) { view_.last_error = "it ended: " + why; }
  /// Told every time it is drawn: a link that searches its rate says where it is.
  void says(std::function<std::string_view()> note) { note_ = std::move(note); }

  DeviceView current() {
    view_.streaming = false;
    if (last_) view_.age_s = measurement::seconds(link::steady_now() - *last_);
    view_.streaming = view_.age_s && *view_.age_s < quiet_after_s;
    view_.state = view_.streaming ? "streaming" : last_ ? "quiet" : "waiting";
    view_.status = last_ ? "nothing more comes" : "nothing came yet";
    if (note_) view_.link_note = note_();
    return view_;
  }
  bool any() const { return last_.has_value(); }

  std::unique_ptr<WireWatch> watch;

 private:
  DeviceView view_;
  std::function<std::string_view()> note_;
  std::optional<measurement::Stamp> last_;
};

template <class Link>
int show_link(MonitorLoop& loop, WireView& wire, Link& open_link) {
  asio::co_spawn(
      loop.io(),
      link::read_until_lost<Link>(
          open_link, [&](const auto& item, measurement::Stamp at) { wire.receive(item, at); }),
      [&](const std::exception_ptr&, const boost::system::error_code& why) {
        if (why != asio::error::operation_aborted) wire.ended(why.message());
      });
  wire.says([&] { return open_link.note(); });
  loop.run([] {}, [&] { open_link.close(); });
  wire.says({});
  return terminal::exit_of(wire.any());
}

}  // namespace

int monitor_wire(const MonitorOptions& options, const link::Uri& uri, link::Carries carries) {
  WireView wire(options, carries);
  const auto views = [&] { return std::vector{wire.current()}; };
  const WireSource source{.show = [&](const DeviceView&) { return wire.watch->show(); }};
  MonitorLoop loop(options, options.protocol, views, source, Pane::raw);
  const auto show_opened = [&](auto opened) {
    if (opened) return show_link(loop, wire, **opened);
    fmt::print(stderr, "monitor: {}\n", opened.error().message);
    return terminal::exit_usage;
  };
  const auto executor = loop.io().get_executor();
  return carries == link::Carries::bytes
             ? show_opened(link::open_bytes(executor, uri, link::Side::driver))
             : show_opened(link::open_frames(executor, uri, link::Side::driver));
}

}  // namespace drydock::monitor
