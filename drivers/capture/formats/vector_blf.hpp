#pragma once

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "drivers/capture/reader.hpp"

namespace drydock::capture {

/// Vector's binary log (CANoe, CANalyzer, python-can): a file head with the local time of the
/// start, then containers of objects, each compressed by zlib. An object may go on in the next
/// container. The layout: Toby Lorenz' Vector BLF and python-can's reader, which found it out;
/// Vector publishes none. Channel n is can(n-1), as in Vector's ASCII log.
class VectorBlf final : public Reader {
 public:
  static constexpr std::string_view name = "blf";
  static bool recognises(Bytes head);

  Scan scan(Bytes bytes, bool at_end) override;
  Reading read(Bytes unit) override;
  std::optional<Record> more() override;

 private:
  bool read_container(Bytes object);
  bool read_objects();
  bool read_object(Bytes object);
  bool read_classic(Bytes object, std::size_t at);
  bool read_fd(Bytes object, std::size_t at);
  bool read_fd_64(Bytes object, std::size_t at);
  bool take(Bytes object, std::uint16_t channel, std::uint32_t id, wire::CanFrame frame,
            Bytes data);

  bool head_read_ = false;
  std::chrono::nanoseconds start_{0};  ///< zero: the head gives no date
  std::vector<std::uint8_t> objects_;  ///< unpacked, not read yet
  std::deque<Record> records_;         ///< of the last container
  std::map<std::uint16_t, std::string> interfaces_;
};

}  // namespace drydock::capture
