#include "drivers/device/device.hpp"

#include <algorithm>
#include <utility>

#include "drivers/device/bus/can_error_text.hpp"
#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/described/description.hpp"

namespace drydock::device {

namespace {

/// Measurements that have different rates are metered separately.
struct RateChannel {
  std::size_t operator()(const measurement::GnssSatellites&) const { return 1; }
  std::size_t operator()(const measurement::DepthSample& m) const { return m.altitude_m ? 1 : 0; }
  std::size_t operator()(const measurement::WaterSpeed& m) const { return m.distance_m ? 1 : 0; }
  std::size_t operator()(const measurement::ActuatorState& m) const {
    if (m.stern_plane_rad) return 1;
    if (m.bow_plane_rad) return 2;
    return m.propeller_radps ? 3 : 0;
  }
  std::size_t operator()(const measurement::AttitudeSample& m) const {
    if (m.rate_of_turn_radps) return 1;
    return m.roll_rad || m.pitch_rad ? 2 : 0;
  }
  template <class Other>
  std::size_t operator()(const Other&) const {
    return 0;
  }
};

bool is_no_text(std::uint8_t byte) {
  const bool printed = byte >= 0x20 && byte <= 0x7E;
  return !printed && byte != '\r' && byte != '\n' && byte != '\t';
}

/// Bytes for a protocol that is not known: then the error says what is allowed.
Travels travels_of(const DriverOptions& options) {
  if (options.description) return options.description->facts.travels;
  const auto protocols = protocols_of(options.kind);
  const auto known = std::ranges::find(protocols, options.protocol, &ProtocolEntry::name);
  return known != protocols.end() ? known->travels : Travels::as_bytes;
}

}  // namespace

Device::Device(DeviceOptions options, AnyDriver driver)
    : options_(std::move(options)), driver_(std::move(driver)), life_cycle_(options_.life_cycle) {}

boost::system::result<std::unique_ptr<Device>, DriverError> Device::make(DeviceOptions options) {
  const auto wrap = [&](auto made) -> boost::system::result<std::unique_ptr<Device>, DriverError> {
    if (!made) return made.error();
    return std::unique_ptr<Device>(new Device(std::move(options), std::move(*made)));
  };
  if (travels_of(options.driver) == Travels::as_frames)
    return wrap(make_frame_driver(options.driver));
  return wrap(make_byte_driver(options.driver));
}

void Device::connect(Listener& listener, Transmitter& transmitter) {
  listener_ = &listener;
  transmitter_ = &transmitter;
}

Driver& Device::driver() const {
  return std::visit([](const auto& d) -> Driver& { return *d; }, driver_);
}

void Device::tell(const LifeCycle::Change& change) {
  if (!change) return;
  if (change->to == State::backing_off) note_error(change->why.view(), change->at);
  if (change->to == State::waiting) {
    for (RateMeter& meter : rates_) meter.reset();
  }
  if (const auto news = news_.tell(change)) listener_->on_state(*this, *news);
}

void Device::note_error(std::string_view what, Stamp at) {
  last_error_ = what;
  last_error_at_ = at;
  ++errors_;
}

void Device::start(Stamp now) { tell(life_cycle_.start(now)); }

void Device::opened(Stamp now, measurement::Provenance provenance) {
  now_ = now;
  tell(life_cycle_.opened(now));
  if (!life_cycle_.uses_link()) return;  // it was stopped in the meantime
  driver().set_provenance(provenance);
  driver().restart(now, *this);
}

void Device::set_baud(unsigned baud) {
  if (auto* byte_driver = std::get_if<std::unique_ptr<ByteDriver>>(&driver_))
    (*byte_driver)->set_baud(baud);
}

void Device::set_bitrate(unsigned bitrate) {
  if (auto* frame_driver = std::get_if<std::unique_ptr<FrameDriver>>(&driver_))
    (*frame_driver)->set_bitrate(bitrate);
}

void Device::open_failed(Stamp now, std::string_view reason) {
  tell(life_cycle_.open_failed(now, reason));
}

void Device::link_lost(Stamp now, std::string_view reason) {
  finish(now);
  tell(life_cycle_.link_lost(now, reason));
}

void Device::stop(Stamp now, std::string_view reason) {
  finish(now);
  tell(life_cycle_.stop(now, reason));
}

void Device::end_of_recording(Stamp now) {
  finish(now);
  life_cycle_.end_of_recording();
}

void Device::finish(Stamp now) {
  now_ = now;
  driver().finish(*this);
}

void Device::receive(wire::Bytes bytes, Stamp at) {
  auto* byte_driver = std::get_if<std::unique_ptr<ByteDriver>>(&driver_);
  if (!byte_driver || !life_cycle_.uses_link()) return;
  now_ = at;
  bytes_not_text_ += static_cast<std::uint64_t>(std::ranges::count_if(bytes, is_no_text));
  (*byte_driver)->receive(bytes, at, *this);
}

void Device::receive(const wire::CanFrame& frame, Stamp at) {
  auto* frame_driver = std::get_if<std::unique_ptr<FrameDriver>>(&driver_);
  if (!frame_driver || !life_cycle_.uses_link()) return;
  if (frame.error) {
    ++error_frames_;
    note_error(can_error_text(frame), at);
    return;
  }
  now_ = at;
  (*frame_driver)->receive(frame, at, *this);
}

void Device::tick(Stamp now) {
  now_ = now;
  if (life_cycle_.uses_link()) driver().tick(now, *this);
  tell(life_cycle_.tick(now));
}

void Device::clock_stepped(std::chrono::nanoseconds step, Stamp now) {
  finish(now);
  clock_moved_ += step;
  life_cycle_.clock_stepped(step);
  if (last_message_at_) *last_message_at_ += step;
  if (last_error_at_) *last_error_at_ += step;
  for (RateMeter& meter : rates_) meter.reset();
  if (life_cycle_.uses_link()) driver().restart(now, *this);
}

std::optional<Stamp> Device::deadline() const {
  const auto of_life = life_cycle_.deadline();
  const auto of_driver = life_cycle_.uses_link() ? driver().deadline() : std::nullopt;
  return measurement::earlier(of_life, of_driver);
}

void Device::publish(const Measurement& measurement) {
  ++messages_;
  last_message_at_ = now_;
  rates_[std::visit(RateChannel{}, measurement)].add(now_);
  tell(life_cycle_.message(now_));
  listener_->on_measurement(measurement);
}

void Device::send(wire::Bytes bytes) {
  if (!listens_only_) transmitter_->send(bytes);
}

void Device::send(const wire::CanFrame& frame) {
  if (!listens_only_) transmitter_->send(frame);
}

void Device::refuse(std::string_view why, Refusal because) {
  ++refused_;
  impossible_ += because == Refusal::impossible;
  if (because == Refusal::no_measurement)
    left_out_ = why;  // it says nothing against its device
  else
    note_error(why, now_);
}

const RateMeter* Device::fastest() const {
  if (state() != State::streaming) return nullptr;
  const RateMeter* fastest = nullptr;
  double most_hz = 0;
  for (const RateMeter& meter : rates_) {
    const auto rate_hz = meter.rate_hz();
    if (!rate_hz || *rate_hz <= most_hz) continue;
    most_hz = *rate_hz;
    fastest = &meter;
  }
  return fastest;
}

Vitals Device::vitals() const {
  const auto opened = life_cycle_.opened_count();
  const RateMeter* const meter = fastest();
  return {.state = state(),
          .since = life_cycle_.since(),
          .stream = driver().counters(),
          .held_bytes = driver().held_bytes(),
          .rate_hz = meter != nullptr ? meter->rate_hz() : std::nullopt,
          .last_message_at = last_message_at_,
          .last_error = last_error_,
          .reopened = opened > 0 ? opened - 1 : 0,
          .link_up_since = life_cycle_.link_up_since(),
          .link_broken_since = life_cycle_.link_broken_since(),
          .link_failures = life_cycle_.link_failures(),
          .bytes_not_text = bytes_not_text_,
          .error_frames = error_frames_,
          .impossible = impossible_};
}

Health Device::health(Stamp now) const {
  Health health;
  static_cast<Vitals&>(health) = vitals();
  health.status = life_cycle_.status(now);
  health.messages = messages_;
  if (const RateMeter* const meter = fastest()) health.jitter = meter->jitter();
  health.nominal_rate_hz = options_.nominal_rate_hz;
  if (last_message_at_) health.age = now - *last_message_at_;
  if (last_error_at_) health.last_error_age = now - *last_error_at_;
  health.errors = errors_;
  health.link_note = link_note_;
  health.can_dropped = can_dropped_;
  health.refused = refused_;
  health.left_out = left_out_;
  return health;
}

}  // namespace drydock::device
