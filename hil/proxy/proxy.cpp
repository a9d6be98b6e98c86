#include "hil/proxy/proxy.hpp"

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>

#include "drivers/link/clock.hpp"
#include "hil/fault/wire/faulty_bus.hpp"
#include "hil/fault/wire/faulty_stream.hpp"
#include "hil/proxy/port.hpp"

namespace drydock::proxy {

namespace asio = boost::asio;

namespace {

using device::State;
using device::Transition;

fault::FaultyStream make_faults(const ProxyOptions& o, Stamp start, const link::ByteLink*) {
  return {o.device, o.seed, o.schedule, start};
}
fault::FaultyBus make_faults(const ProxyOptions& o, Stamp start, const link::FrameLink*) {
  return {o.device, *o.real.bitrate(), o.seed, o.schedule, start};
}

template <class Link>
class ProxyOf final : public Proxy, private fault::Outlet {
 public:
  using Run = typename Port<Link>::Run;
  using Item = typename Port<Link>::Item;

  ProxyOf(asio::io_context& io, ProxyOptions options)
      : options_(std::move(options)),
        faults_(make_faults(options_, link::steady_now(), static_cast<Link*>(nullptr))),
        real_(io, options_.real, link::Side::driver,
              {[this](const Item& item, Stamp at) { return from_device(item, at); },
               [this](const Transition& change) { real_changed(change); },
               {},
               [this] { takes_nothing(options_.real, "the drivers"); }}),
        virtual_(io, options_.virt, link::Side::device,
                 {[this](const Item& item, Stamp at) { return from_drivers(item, at); },
                  [this](const Transition& change) { virtual_changed(change); },
                  [this](Stamp read_at) { latency_.add(link::steady_now() - read_at); },
                  [this] { takes_nothing(options_.virt, "the device"); }}),
        clock_(std::make_shared<io::Signal>(io.get_executor())) {
    real_.want(true);
    asio::co_spawn(io, real_.serve(), asio::detached);
    asio::co_spawn(io, virtual_.serve(), asio::detached);
    asio::co_spawn(io, keep_time(), asio::detached);
  }

  void finish() override {
    finished_ = true;
    real_.finish();
    virtual_.finish();
    clock_->notify();
  }
  void rearm() override { clock_->notify(); }

  Passed passed() const override {
    const auto [from_device, to_device, not_taken] = real_.counters();
    const auto [from_drivers, to_drivers, not_heard] = virtual_.counters();
    return {from_device, to_drivers, from_drivers, to_device, not_taken + not_heard};
  }
  fault::FaultHits hits() const override { return faults_.hits(); }
  const Latency& latency() const override { return latency_; }

 private:
  Run from_device(const Item& item, Stamp at) {
    read_at_ = at;
    faults_.receive(item, at, *this);
    read_at_.reset();
    rearm_if_earlier();
    co_return;
  }

  Run from_drivers(const Item& item, Stamp) {
    if (faults_.hears()) real_.put(item);
    co_return;
  }

  Run keep_time() {
    while (!finished_) {
      set_for_ = faults_.deadline();
      co_await clock_->wait_until(set_for_, link::steady_now());
      if (finished_) co_return;
      const Stamp now = link::steady_now();
      if (const auto due = faults_.deadline(); due && *due <= now) faults_.tick(now, *this);
    }
  }

  void rearm_if_earlier() {
    const auto due = faults_.deadline();
    if (due && (!set_for_ || *due < *set_for_)) clock_->notify();
  }

  void pass(wire::Bytes bytes, Stamp) override {
    if constexpr (std::is_same_v<Item, wire::Bytes>) pass_on(bytes);
  }
  void pass(const wire::CanFrame& frame, Stamp) override {
    if constexpr (std::is_same_v<Item, wire::CanFrame>) pass_on(frame);
  }
  void pass_on(const Item& item) { virtual_.put(item, read_at_); }
  void set_port(bool there, Stamp) override {
    say(there ? "the fault ends: the virtual side comes back" : "fault: the virtual side is gone");
    virtual_.want(there && real_.is_open());
  }

  void takes_nothing(const link::Uri& side, const char* speaker) const {
    say(side.text + ": takes nothing; what " + speaker + " says is lost until it does");
  }

  /// A side that stays away is reported once.
  void real_changed(const Transition& change) {
    const bool is_there = change.to == State::waiting;
    if (is_there) {
      say(options_.real.text + ": open");
    } else if (change.to == State::backing_off) {
      if (!real_is_away_) say(options_.real.text + ": " + std::string(change.why.view()));
      faults_.drop_all();
    }
    if (change.to == State::waiting || change.to == State::backing_off) real_is_away_ = !is_there;
    if (real_is_away_) virtual_.want(false);
    if (is_there) virtual_.want(faults_.has_port());
  }

  void virtual_changed(const Transition& change) {
    const bool is_there = change.to == State::waiting;
    if (is_there) say("drivers: " + place_of(options_.virt));
    if (change.to == State::backing_off && !virtual_is_away_)
      say(options_.virt.text + ": " + std::string(change.why.view()));
    if (change.to == State::waiting || change.to == State::backing_off)
      virtual_is_away_ = !is_there;
  }

  void say(const std::string& line) const {
    if (options_.say && !finished_) options_.say(line);
  }

  ProxyOptions options_;
  std::conditional_t<std::is_same_v<Link, link::ByteLink>, fault::FaultyStream, fault::FaultyBus>
      faults_;
  Port<Link> real_, virtual_;
  std::shared_ptr<io::Signal> clock_;  ///< wakes when the faults need a tick
  std::optional<Stamp> set_for_;
  Latency latency_;
  std::optional<Stamp> read_at_;  ///< of what the faults now receive
  bool finished_ = false, real_is_away_ = false, virtual_is_away_ = false;
};

}  // namespace

std::unique_ptr<Proxy> Proxy::start(asio::io_context& io, ProxyOptions options) {
  if (options.real.carries() == link::Carries::frames)
    return std::make_unique<ProxyOf<link::FrameLink>>(io, std::move(options));
  return std::make_unique<ProxyOf<link::ByteLink>>(io, std::move(options));
}

std::string place_of(const link::Uri& virt) {
  if (virt.scheme == link::Scheme::pty) return link::pty_path(virt.target);
  if (virt.scheme == link::Scheme::can_auto) return link::can_auto_level(virt);
  return virt.text;
}

}  // namespace drydock::proxy
