#include "drivers/link/can/listening.hpp"

#include <utility>

#include "drivers/link/error_words.hpp"

namespace drydock::link {
namespace {

class NeverWrites final : public ErrorWords {
 public:
  const char* name() const noexcept override { return "listening"; }
  std::string message(int) const override {
    return "this link only listens: it has listen=1, or is a gateway of which only format=ydwg "
           "takes frames";
  }
};

ErrorCode never_writes() {
  static const NeverWrites category;
  return {1, category};
}

class ListeningLink final : public FrameLink {
 public:
  explicit ListeningLink(std::unique_ptr<FrameLink> bus) : bus_(std::move(bus)) {}

  Task<ReceivedFrame> read() override { return bus_->read(); }
  Task<void> write(const wire::CanFrame&) override { co_return never_writes(); }
  void close() override { bus_->close(); }
  Provenance provenance() const override { return bus_->provenance(); }
  std::uint64_t dropped() const override { return bus_->dropped(); }
  std::optional<unsigned> bit_rate() const override { return bus_->bit_rate(); }
  std::string_view note() const override { return bus_->note(); }

 private:
  std::unique_ptr<FrameLink> bus_;
};

}  // namespace

std::unique_ptr<FrameLink> make_listening(std::unique_ptr<FrameLink> bus) {
  return std::make_unique<ListeningLink>(std::move(bus));
}

}  // namespace drydock::link
