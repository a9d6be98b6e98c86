#include "hil/emulate/devices.hpp"
#include "hil/emulate/gnss/nmea_commands.hpp"
#include "hil/emulate/gnss/nmea_sentences.hpp"

namespace drydock::emulate {
namespace {

/// RMC, GGA and VTG come first, because a client may need all three within a short time, and at
/// 9600 baud the satellites behind them take long.
class Nmea0183Gnss final : public SamplingDevice {
 public:
  explicit Nmea0183Gnss(const DeviceSetup& setup) : SamplingDevice(setup), sensor_(setup) {
    sample_at_whole_multiples();
  }

  void tick(Stamp now, Wire& out) override {
    greet(out);
    SamplingDevice::tick(now, out);
  }

  using SamplingDevice::receive;
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override {
    greet(out);
    const auto before = commands_.period_s();
    commands_.receive(bytes, out);
    if (commands_.period_s() != before)
      go_on_at_whole_multiples(1 / *commands_.period_s(),
                               std::max(now, last_epoch_ + std::chrono::nanoseconds{1}));
  }

 private:
  void greet(Wire& out) {
    if (!std::exchange(greeted_, true) && out.line_baud() > 0) out.set_baud(out.line_baud());
  }

  void sample(Stamp at, Wire& out) override {
    last_epoch_ = at;
    const GnssEpoch epoch = sensor_.measure(trajectory().at(at), mounting());
    ++epochs_;
    send_if_due(0, rmc(epoch), out);
    send_if_due(1, gga(epoch), out);
    send_if_due(2, vtg(epoch), out);
    send_if_due(3, gsa(epoch), out);
    each_gsv(epoch, [&](const wire::Gsv& sentence) { send_if_due(4, sentence, out); });
    send_if_due(5, gll(epoch), out);
    send_if_due(6, zda(epoch), out);
  }

  /// `place`: in nmea_receiver_sentences.
  template <class Sentence>
  void send_if_due(std::size_t place, const Sentence& sentence, Wire& out) {
    const int each = commands_.each(place);
    if (each > 0 && epochs_ % static_cast<std::uint64_t>(each) == 0)
      out.send(wire::Bytes{bytes_}.first(wire::encode(sentence, bytes_)));
  }

  GnssSensor sensor_;
  NmeaCommands commands_;
  bool greeted_ = false;
  Stamp last_epoch_{};
  std::uint64_t epochs_ = 0;
  std::array<std::uint8_t, 256> bytes_{};
};

}  // namespace

DevicePtr make_nmea0183_gnss(const DeviceSetup& setup) {
  return std::make_unique<Nmea0183Gnss>(setup);
}

}  // namespace drydock::emulate
