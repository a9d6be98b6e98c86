#include "hil/emulate/line_sharers.hpp"

#include <utility>

#include "drivers/measurement/earlier.hpp"

namespace drydock::emulate {

/// One device's end of the line.
class LineSharers::Sharer final : public Wire {
 public:
  Sharer(std::string name, std::unique_ptr<EmulatedDevice> device, int& unplugged_by)
      : name_(std::move(name)), device_(std::move(device)), unplugged_by_(unplugged_by) {}

  /// Lets the device act on this line.
  template <class Act>
  void with(Wire& line, Act act) {
    line_ = &line;
    act(*device_, *this);
  }
  const EmulatedDevice& device() const { return *device_; }
  const std::string& name() const { return name_; }

  void send(wire::Bytes bytes) override { line_->send(bytes); }
  void send(const wire::CanFrame&) override {}  // a line carries no frames
  void send_to(Client client, wire::Bytes bytes) override { line_->send_to(client, bytes); }
  Client speaker() const override { return line_->speaker(); }
  unsigned line_baud() const override { return line_->line_baud(); }
  void set_baud(unsigned baud) override { line_->set_baud(baud); }
  void tell(std::string_view what) override { line_->tell(what); }
  void unplug() override {
    if (!std::exchange(unplugs_, true) && unplugged_by_++ == 0) line_->unplug();
  }
  void plug() override {
    if (std::exchange(unplugs_, false) && --unplugged_by_ == 0) line_->plug();
  }

 private:
  std::string name_;
  std::unique_ptr<EmulatedDevice> device_;
  Wire* line_ = nullptr;  ///< while the device acts
  int& unplugged_by_;     ///< how many of the sharers
  bool unplugs_ = false;
};

LineSharers::LineSharers() = default;
LineSharers::~LineSharers() = default;

void LineSharers::add(std::string name, std::unique_ptr<EmulatedDevice> device) {
  sharers_.push_back(std::make_unique<Sharer>(std::move(name), std::move(device), unplugged_by_));
}

std::optional<Stamp> LineSharers::deadline() const {
  std::optional<Stamp> next;
  for (const auto& sharer : sharers_)
    next = measurement::earlier(next, sharer->device().deadline());
  return next;
}

void LineSharers::tick(Stamp now, Wire& out) {
  for (speaks_ = 0; speaks_ < sharers_.size(); ++speaks_) {
    const auto due = sharers_[speaks_]->device().deadline();
    if (!due || *due > now) continue;
    sharers_[speaks_]->with(out,
                            [&](EmulatedDevice& device, Wire& line) { device.tick(now, line); });
  }
  speaks_ = 0;
}

void LineSharers::receive(wire::Bytes bytes, Stamp now, Wire& out) {
  for (speaks_ = 0; speaks_ < sharers_.size(); ++speaks_)
    sharers_[speaks_]->with(
        out, [&](EmulatedDevice& device, Wire& line) { device.receive(bytes, now, line); });
  speaks_ = 0;
}

std::optional<Stamp> LineSharers::sampled_at() const {
  return sharers_[speaks_]->device().sampled_at();
}

const std::string& LineSharers::name_of(std::size_t sender) const {
  return sharers_.at(sender)->name();
}

}  // namespace drydock::emulate
