#pragma once

#include "drivers/shell/baud_search.hpp"
#include "drivers/shell/linked_line.hpp"

namespace drydock::shell {

/// A serial line, socket or file with its devices.
class ByteLine final : public LinkedLine<link::ByteLink> {
 public:
  using LinkedLine::LinkedLine;

 private:
  link::Uri next_uri() override;
  Opened open(const link::Uri& uri) override;
  void observe_link() override;
  void receive(const wire::Bytes& bytes, Stamp at) override;
  void send(wire::Bytes bytes) override { put(bytes); }
  void send(const wire::CanFrame&) override {}  // no driver of a byte link sends frames

  BaudSearch search_;
  std::uint64_t heard_before_ = 0;  ///< messages at the time of the last opening
};

}  // namespace drydock::shell
