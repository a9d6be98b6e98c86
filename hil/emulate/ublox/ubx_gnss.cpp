#include "drivers/wire/ubx/ubx_settings.hpp"
#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/nmea_sentences.hpp"
#include "hil/emulate/ublox/ublox_dialogue.hpp"
#include "hil/emulate/ublox/ublox_messages.hpp"
#include "hil/emulate/ublox/ublox_status.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {
namespace {

namespace ubx = wire::ubx;

/// Time to the first fix, NEO-M8 data sheet (UBX-15031086).
constexpr std::chrono::seconds cold_start{26}, hot_start{1};

/// Sends the messages that its settings name, each at its rate, and obeys its dialogue.
class UbxGnss final : public SamplingDevice, private ublox::Owner {
 public:
  explicit UbxGnss(const DeviceSetup& setup)
      : SamplingDevice(setup),
        sensor_(setup),
        boot_(setup.boot),
        first_fix_s_(setup.config.emulate.first_fix_s),
        settings_(setup.config.emulate.model, rate_hz(), setup.memory),
        delivered_period_s_(settings_.delivered_period_s()) {
    sample_at_whole_multiples();
    follow_settings(setup.boot);
  }

  void tick(Stamp now, Wire& out) override {
    greet(out);
    SamplingDevice::tick(now, out);
  }

  using SamplingDevice::receive;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override {
    greet(out);
    now_ = now;
    dialogue_.receive(bytes, now, condition().under(FaultKind::nak) != nullptr, out);
    follow_settings(now);
  }

 private:
  /// It was delivered with the line's rate. It tells the line the rate that it woke with.
  void greet(Wire& out) {
    if (std::exchange(greeted_, true)) return;
    if (out.line_baud() > 0) settings_.deliver_baud(out.line_baud());
    out.set_baud(static_cast<unsigned>(settings_[ublox::baud]));
  }

  void follow_settings(Stamp now) {
    sensor_.receive_gps(runs_ && settings_[ublox::gps] != 0);
    const double period_s = settings_.period_s();
    if (period_s == period_s_.value_or(delivered_period_s_)) return;
    period_s_ = period_s;
    go_on_at_whole_multiples(1 / period_s,
                             std::max(now, last_epoch_ + std::chrono::nanoseconds{1}));
  }

  void sample(Stamp at, Wire& out) override {
    last_epoch_ = at;
    epoch_ = sensor_.measure(trajectory().at(at), mounting());
    ++epochs_;
    for (const auto& message : ublox::message_facts()) {
      const auto rate = rate_of(message.class_and_id);
      if (rate > 0 && epochs_ % rate == 0) send_message(message.class_and_id, out);
    }
  }

  std::uint64_t rate_of(std::uint16_t class_and_id) const {
    const auto item = ublox::rate_item(class_and_id, ublox::uart1, settings_.model());
    const bool nmea = class_and_id >> 8 == 0xF0;
    if (!item || settings_[nmea ? ublox::out_nmea : ublox::out_ubx] == 0) return 0;
    return settings_[*item];
  }

  void send_message(std::uint16_t class_and_id, Wire& out) override {
    switch (class_and_id) {
      case wire::NavPvt::class_and_id: return send(ublox::nav_pvt(epoch_), out);
      case wire::NavSat::class_and_id: return send(ublox::nav_sat(epoch_), out);
      case wire::NavSol::class_and_id: return send(ublox::nav_sol(epoch_), out);
      case wire::NavStatus::class_and_id: return send(status(), out);
      case wire::NavPosllh::class_and_id: return send(ublox::nav_posllh(epoch_), out);
      case wire::NavVelned::class_and_id: return send(ublox::nav_velned(epoch_), out);
      case wire::NavDop::class_and_id: return send(ublox::nav_dop(epoch_), out);
      case wire::NavTimeGps::class_and_id: return send(ublox::nav_timegps(epoch_), out);
      case wire::NavSvinfo::class_and_id: return send(ublox::nav_svinfo(epoch_), out);
      case wire::NavEoe::class_and_id: return send(wire::NavEoe{epoch_.time_of_week}, out);
      case ublox::nav_timeutc: return put_out(ublox::encode_utc(epoch_, bytes_), out);
      case ubx::mon_hw: return put_out(ublox::encode_hardware(bytes_), out);
      case ubx::mon_hw2: return put_out(ublox::encode_hardware_2(bytes_), out);
      case ublox::mon_rf: return put_out(ublox::encode_radio(bytes_), out);
      case ubx::tim_tm2: return put_out(time_mark(), out);
      default: return send_sentence(class_and_id, out);
    }
  }

  /// A time mark goes out by itself only after an edge at EXTINT, which nobody makes.
  std::size_t time_mark() { return under_way() ? 0 : ublox::encode_time_mark(bytes_); }
  bool under_way() const { return sampled_at().has_value(); }

  void send_sentence(std::uint16_t class_and_id, Wire& out) {
    const std::string_view name = ubx::name_of_message(class_and_id);
    if (name == wire::Rmc::type) send(rmc(epoch_), out);
    if (name == wire::Gga::type) send(gga(epoch_), out);
    if (name == wire::Vtg::type) send(vtg(epoch_), out);
    if (name == wire::Gsa::type) send(gsa(epoch_), out);
    if (name == wire::Gll::type) send(gll(epoch_), out);
    if (name == wire::Zda::type) send(zda(epoch_), out);
    if (name == wire::Gsv::type)
      each_gsv(epoch_, [&](const wire::Gsv& sentence) { send(sentence, out); });
  }

  wire::NavStatus status() const {
    const double uptime_s = measurement::seconds(epoch_.sky.origin.valid_at - boot_);
    return ublox::nav_status(epoch_, std::max(uptime_s, 0.0), first_fix_s_);
  }

  template <class Message>
  void send(const Message& message, Wire& out) {
    put_out(wire::encode(message, bytes_), out);
  }
  void put_out(std::size_t size, Wire& out) {
    if (size == 0) return;
    out.send(wire::Bytes{bytes_}.first(size));
    dialogue_.count_sent(size);
  }

  void search_again(bool cold) override {
    sensor_.search_again(now_, cold ? cold_start : hot_start);
    first_fix_s_ = measurement::seconds(cold ? cold_start : hot_start);
    boot_ = now_;
  }
  void run_gnss(bool runs) override { runs_ = runs; }

  GnssSensor sensor_;
  Stamp boot_, now_{};
  double first_fix_s_;
  ublox::UbloxSettings settings_;
  ublox::UbloxDialogue dialogue_{settings_, *this};
  double delivered_period_s_;
  std::optional<double> period_s_;  ///< that a host or the memory has set
  bool greeted_ = false, runs_ = true;
  GnssEpoch epoch_;  ///< the last one, for polls
  Stamp last_epoch_{};
  std::uint64_t epochs_ = 0;
  std::array<std::uint8_t, 2048> bytes_{};
};

}  // namespace

DevicePtr make_ubx_gnss(const DeviceSetup& setup) { return std::make_unique<UbxGnss>(setup); }

}  // namespace drydock::emulate
