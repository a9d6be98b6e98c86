#pragma once

#include <deque>
#include <string>

#include "drivers/wire/described/description.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// Hears the requests of a description in what a driver says. A sensor with a start sends nothing
/// by itself before it has heard all of it.
class RequestListener {
 public:
  using Requests = std::vector<wire::described::Request>;

  explicit RequestListener(const wire::described::Description& description)
      : start_(description.start), poll_(description.poll) {
    for (const Requests* all : {&start_, &poll_})
      for (const auto& request : *all) longest_ = std::max(longest_, request.bytes.size());
  }

  /// Calls `on_start(request)` and `on_poll(request)` for what the bytes complete.
  template <class OnStart, class OnPoll>
  void feed(wire::Bytes bytes, OnStart&& on_start, OnPoll&& on_poll) {
    for (const std::uint8_t byte : bytes) {
      heard_ += static_cast<char>(byte);
      if (heard_.size() > longest_) heard_.erase(0, heard_.size() - longest_);
      if (const auto* request = ended(start_)) {
        done_ += done_ < start_.size() && request == &start_[done_];
        on_start(*request);
      } else if (const auto* poll = ended(poll_)) {
        on_poll(*poll);
      }
    }
  }

  bool started() const { return done_ == start_.size(); }

 private:
  const wire::described::Request* ended(const Requests& requests) const {
    for (const auto& request : requests)
      if (heard_.ends_with(request.bytes)) return &request;
    return nullptr;
  }

  const Requests &start_, &poll_;
  std::string heard_;
  std::size_t longest_ = 0, done_ = 0;
};

}  // namespace drydock::emulate
