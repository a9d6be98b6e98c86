#include <fmt/format.h>

#include "drivers/monitor/frames/field_lister.hpp"
#include "drivers/monitor/frames/kept_frame.hpp"
#include "drivers/monitor/frames/wire_watch.hpp"
#include "drivers/wire/described/frame_codec.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::monitor {
namespace {

/// A CAN identifier, and whether it has 29 bits or is of an error frame: these sort behind.
using IdKey = std::pair<int, std::uint32_t>;

IdKey key_of(const wire::CanFrame& frame) {
  return {frame.error ? 2 : frame.extended ? 1 : 0, frame.id};
}

std::string id_text(const IdKey& key) {
  if (key.first == 2) return fmt::format("error {:X}", key.second);
  return fmt::format("{:0{}X}", key.second, key.first == 1 ? 8 : 3);
}

/// The last messages of one protocol, by the identifier that completed them.
class BusReader {
 public:
  virtual ~BusReader() = default;
  virtual void receive(const wire::CanFrame& frame, measurement::Stamp at) = 0;
  virtual void list(const IdKey& key, std::vector<ShownValue>& into) const = 0;
};

template <class Decoder>
class DecodedBus final : public BusReader {
 public:
  explicit DecodedBus(Decoder decoder) : decoder_(std::move(decoder)) {}
  void receive(const wire::CanFrame& frame, measurement::Stamp at) override {
    auto message = wire::receive_at(decoder_, frame, at.time_since_epoch());
    if (!message) return;
    const auto known = last_.find(key_of(frame));
    if (known != last_.end())
      known->second = *message;
    else if (last_.size() < WireWatch::most_kinds)
      last_.emplace(key_of(frame), *message);
  }
  void list(const IdKey& key, std::vector<ShownValue>& into) const override {
    const auto found = last_.find(key);
    if (found == last_.end()) return;
    std::visit(
        [&](const auto& m) {
          into.push_back({"type", std::string(m.type), ""});
          visit_fields(m, FieldLister(into));
        },
        found->second);
  }

 private:
  using Message = typename decltype(std::declval<Decoder&>().receive(wire::CanFrame{}))::value_type;
  Decoder decoder_;
  std::map<IdKey, Message> last_;
};

class Sniffer final : public BusWatch {
 public:
  void add(const std::string& protocol,
           const wire::described::DescriptionPtr& description) override {
    using wire::described::FrameDecoder;
    if (readers_.contains(protocol)) return;
    if (description && description->frames)
      readers_[protocol] = std::make_unique<DecodedBus<FrameDecoder>>(FrameDecoder(description));
    else
      wire::with_protocol(wire::FrameProtocols{}, protocol, [&]<class P>() {
        using Decoder = typename P::Decoder;
        readers_[protocol] = std::make_unique<DecodedBus<Decoder>>(Decoder{});
      });
  }

  using WireWatch::receive;
  void receive(const wire::CanFrame& frame, measurement::Stamp at) override {
    for (auto& [protocol, reader] : readers_) reader->receive(frame, at);
    const auto known = identifiers_.find(key_of(frame));
    if (known != identifiers_.end()) return known->second.take(frame.payload(), at);
    if (identifiers_.size() >= most_kinds) return void(++not_listed_);
    identifiers_[key_of(frame)].take(frame.payload(), at);
  }

  ShownWire show() override {
    ShownWire wire{.not_listed = not_listed_};
    for (auto& [key, kept] : identifiers_) {
      wire.frames.push_back(kept.show(id_text(key)));
      for (const auto& [protocol, reader] : readers_) reader->list(key, wire.frames.back().fields);
    }
    return wire;
  }

 private:
  std::map<IdKey, KeptFrame> identifiers_;
  std::map<std::string, std::unique_ptr<BusReader>> readers_;
  std::uint64_t not_listed_ = 0;
};

}  // namespace

std::unique_ptr<BusWatch> watch_bus() { return std::make_unique<Sniffer>(); }

}  // namespace drydock::monitor
