#pragma once

#include <array>
#include <memory>
#include <vector>

#include "drivers/shell/baud_search.hpp"
#include "drivers/shell/line.hpp"

namespace drydock::shell {

/// A serial line, socket or file with its one device.
class ByteLine final : public Line {
 public:
  using Line::Line;

 private:
  boost::system::result<Provenance, link::OpenError> open_link() override;
  Run read_until_lost() override;
  Run write_until_lost() override;
  void close_link() override { link_->close(); }
  void destroy_link() override { link_.reset(); }
  void send(wire::Bytes bytes) override;
  void send(const wire::CanFrame&) override {}  // no driver of a byte link sends frames

  link::Uri next_uri();

  BaudSearch search_;
  std::uint64_t heard_before_ = 0;  ///< messages at the time of the last opening
  std::unique_ptr<link::ByteLink> link_;
  std::array<std::uint8_t, 4096> read_buffer_{};
  std::vector<std::uint8_t> queued_, writing_;
};

}  // namespace drydock::shell
