#include "drivers/device/timed_framer.hpp"
#include "drivers/monitor/frames/field_lister.hpp"
#include "drivers/monitor/frames/kept_frame.hpp"
#include "drivers/monitor/frames/wire_watch.hpp"
#include "drivers/wire/described/described_codec.hpp"
#include "drivers/wire/registry.hpp"

namespace drydock::monitor {
namespace {

/// `Codec`: one of the registry, or DescribedCodec. A frame is decoded when it comes, for its type,
/// and again when it is shown: a message may refer to its frame.
template <class Codec>
class ByteWatch final : public WireWatch {
 public:
  explicit ByteWatch(Codec codec) : codec_(std::move(codec)) {}
  using WireWatch::receive;
  void receive(wire::Bytes bytes, measurement::Stamp at) override {
    const auto scan = [this](wire::Bytes all) { return codec_.scan(all); };
    framer_.feed(bytes, at, scan, [&](wire::Bytes frame, const device::Arrival& arrival) {
      take(frame, arrival.read_at);
    });
  }
  ShownWire show() override {
    ShownWire wire{.not_listed = not_listed_};
    for (auto& [type, kept] : kinds_) {
      wire.frames.push_back(kept.show(type));
      if (const auto message = codec_.decode(kept.bytes()))
        std::visit([&](const auto& m) { visit_fields(m, FieldLister(wire.frames.back().fields)); },
                   *message);
    }
    return wire;
  }

 private:
  void take(wire::Bytes frame, measurement::Stamp at) {
    const auto message = codec_.decode(frame);
    const std::string_view type =
        message ? std::visit([](const auto& m) -> std::string_view { return m.type; }, *message)
                : std::string_view("not decoded");
    auto kind = kinds_.find(type);
    if (kind == kinds_.end()) {
      if (kinds_.size() >= most_kinds) return void(++not_listed_);
      kind = kinds_.try_emplace(std::string(type)).first;
    }
    kind->second.take(frame, at);
  }

  Codec codec_;
  device::TimedFramer<Codec::max_frame> framer_;
  std::map<std::string, KeptFrame, std::less<>> kinds_;
  std::uint64_t not_listed_ = 0;
};

}  // namespace

std::unique_ptr<WireWatch> watch_bytes(const std::string& protocol,
                                       const wire::described::DescriptionPtr& description) {
  using wire::described::DescribedCodec;
  if (description)
    return description->frames
               ? nullptr
               : std::make_unique<ByteWatch<DescribedCodec>>(DescribedCodec(description));
  std::unique_ptr<WireWatch> watch;
  wire::with_protocol(wire::BytesProtocols{}, protocol,
                      [&]<class P>() { watch = std::make_unique<ByteWatch<P>>(P{}); });
  return watch;
}

}  // namespace drydock::monitor
