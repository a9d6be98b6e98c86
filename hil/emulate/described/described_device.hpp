#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "drivers/measurement/earlier.hpp"
#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "hil/emulate/described/described_dialogue.hpp"
#include "hil/emulate/described/described_frames.hpp"
#include "hil/emulate/sampling_device.hpp"
#include "rig_config/fault_vocabulary.hpp"

namespace drydock::emulate {

/// A device whose messages a file describes. `Base` samples; measure() says what it read. A sensor
/// that is polled samples when it is asked, and answers after its latency.
template <class Base>
class DescribedDevice : public Base {
 public:
  template <class... Parts>
  explicit DescribedDevice(const DeviceSetup& setup, Parts&&... parts)
      : Base(setup, std::forward<Parts>(parts)...),
        description_(setup.config.description),
        requests_(*description_) {
    if (!description_->frames) return;
    frames_.emplace(*description_);
    turns_ = turns_of(*description_);
    if (const auto sender = sender_of(*description_, setup.config.address))
      node_.emplace(wire::j1939::to_value(sender->name(setup.config)), sender->address, setup.boot);
  }

  std::optional<Stamp> deadline() const override {
    if (node_ && node_->is_booting()) return node_->deadline();
    const auto next = later_.empty() ? std::nullopt : std::optional(later_.begin()->first);
    return measurement::earlier(node_ ? node_->deadline() : std::nullopt,
                                measurement::earlier(next, due()));
  }
  std::optional<Stamp> sampled_at() const override { return late_ ? late_ : Base::sampled_at(); }
  void tick(Stamp now, Wire& out) override {
    if (node_) node_->tick(now, out);
    send_later(now, out);
    if (!is_polled()) return Base::tick(now, out);
    while (!asked_.empty() && asked_.front().at + this->latency() <= now) {
      this->take(asked_.front().at, out);
      asked_.pop_front();
    }
  }
  void receive(const wire::CanFrame& frame, Stamp now, Wire& out) override {
    if (node_) node_->receive(frame, now, out);
  }
  void receive(wire::Bytes bytes, Stamp now, Wire& out) override {
    requests_.feed(
        bytes, [&](const Request& request) { answer(request, out); },
        [&](const Request& request) { ask(request, now, out); });
  }

 protected:
  /// What it measures at a time. A target without a value is none. The times are added later.
  virtual void measure(Stamp at, wire::described::Readings& readings) = 0;

 private:
  using Request = wire::described::Request;
  using Message = wire::described::Message;
  struct Asked {
    Stamp at;
    const std::string* reply;
  };
  struct Later {
    Stamp sampled_at;
    wire::CanFrame frame;
  };
  static constexpr std::size_t most_asked = 16;  ///< a driver that asks faster loses answers

  std::optional<Stamp> due() const {
    if (!is_polled()) return Base::deadline();
    return asked_.empty() ? std::nullopt : std::optional(asked_.front().at + this->latency());
  }

  bool is_polled() const { return !description_->poll.empty(); }

  void ask(const Request& request, Stamp now, Wire& out) {
    if (asked_.size() == most_asked) return;
    asked_.push_back({now, &request.reply});
    if (this->latency().count() == 0) tick(now, out);
  }

  void sample(Stamp at, Wire& out) override {
    if (!requests_.started() || !has_address()) return;
    readings_.clear();
    measure(at, readings_);
    add_times(at);
    for (const Message& message : description_->plan.messages)
      if (is_wanted(message)) send(message, out);
  }

  /// False for a node of J1939 without an address: it is silent.
  bool has_address() {
    if (!node_) return true;
    if (const auto address = node_->address()) frames_->set_address(*address);
    return node_->address().has_value();
  }

  /// A poll that names no reply is answered with all that the device measures.
  bool is_wanted(const Message& message) const {
    if (frames_ && !turns_[place_of(message)].has(this->samples())) return false;
    if (!is_polled() || asked_.front().reply->empty()) return message.emulated;
    return message.name == *asked_.front().reply;
  }

  void add_times(Stamp at) {
    using enum wire::described::Target;
    const auto seconds = [&](Stamp when) {
      return measurement::seconds(this->device_time(when).time_since_epoch());
    };
    readings_.set(time, seconds(at));
    readings_.set(valid_at, seconds(at));
    readings_.set(sent_at, seconds(at + this->latency()));
    readings_.set(age, measurement::seconds(this->latency()));
    set_date(readings_, readings_.get(utc).value_or(seconds(at)));
    readings_.set(interval, 1 / this->rate_hz());
  }

  static void set_date(wire::described::Readings& readings, double since_1970_s) {
    constexpr double day_s = 86400;
    readings.set(wire::described::Target::date, day_s * std::floor(since_1970_s / day_s));
  }

  void answer(const Request& request, Wire& out) {
    const bool refuses = !request.refusal.empty() && this->condition().under(FaultKind::nak);
    const std::string& said = refuses ? request.refusal : request.reply;
    readings_.clear();
    for (const Message& message : description_->plan.messages)
      if (!said.empty() && message.name == said) send(message, out);
  }

  void send(const Message& message, Wire& out) {
    if (frames_) return send_frames(message, out);
    const std::size_t size =
        wire::described::encode(description_->plan, message, readings_, bytes_);
    if (size > 0) out.send(wire::Bytes{bytes_}.first(size));
  }

  /// A multiplexed message sends one selection each cycle time: what it sampled is spread evenly
  /// over the time up to the next sample.
  void send_frames(const Message& message, Wire& out) {
    const std::size_t place = place_of(message);
    const auto& turns = description_->frames->frames[place].turns;
    const Stamp at = *this->sampled_at();
    const double seconds = turns_[place].samples() / this->rate_hz();
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const auto frame = frames_->encode(place, turns[i], readings_);
      const double share = static_cast<double>(i) / static_cast<double>(turns.size());
      if (frame && i == 0)
        out.send(*frame);
      else if (frame && !this->sample_is_lost())
        later_.emplace(at + this->latency() + measurement::from_seconds(share * seconds),
                       Later{at, *frame});
    }
  }

  void send_later(Stamp now, Wire& out) {
    while (!later_.empty() && later_.begin()->first <= now) {
      late_ = later_.begin()->second.sampled_at;
      out.send(later_.begin()->second.frame);
      late_.reset();
      later_.erase(later_.begin());
    }
  }

  std::size_t place_of(const Message& message) const {
    return static_cast<std::size_t>(&message - description_->plan.messages.data());
  }

  wire::described::DescriptionPtr description_;
  std::optional<wire::described::FrameEncoder> frames_;  ///< of a DBC file
  std::vector<Turn> turns_;                              ///< of the frames of each message
  std::optional<J1939Node> node_;                        ///< on J1939
  std::multimap<Stamp, Later> later_;                    ///< by the time when it is sent
  std::optional<Stamp> late_;                            ///< while such a frame is sent: its sample
  RequestListener requests_;
  std::deque<Asked> asked_;
  wire::described::Readings readings_;
  std::array<std::uint8_t, wire::described::longest_frame> bytes_{};
};

}  // namespace drydock::emulate
