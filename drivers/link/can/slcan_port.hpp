#pragma once

#include <memory>
#include <vector>

#include "drivers/link/can/frame_hub.hpp"

namespace drydock::link {

/// An emulated CAN bus with slcan adapters, one for each byte link. A frame from any member or from
/// any program behind an adapter reaches all others. The bus ends when the last member has closed.
class SlcanBus : public std::enable_shared_from_this<SlcanBus> {
 public:
  static std::shared_ptr<SlcanBus> open(const asio::any_io_executor& executor,
                                        std::vector<std::unique_ptr<ByteLink>> lines);
  SlcanBus(const SlcanBus&) = delete;
  SlcanBus& operator=(const SlcanBus&) = delete;
  ~SlcanBus();

  /// Adds a member in this process, on the bus's executor.
  std::unique_ptr<FrameLink> join();

 private:
  class Port;
  explicit SlcanBus(const asio::any_io_executor& executor) : executor_(executor) {}

  asio::any_io_executor executor_;
  std::shared_ptr<FrameHub> hub_ = std::make_shared<FrameHub>();
  std::vector<std::shared_ptr<Port>> ports_;
};

}  // namespace drydock::link
