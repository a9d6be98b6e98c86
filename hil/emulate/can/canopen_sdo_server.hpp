#pragma once

#include <string_view>

#include "drivers/wire/canopen/canopen_segments.hpp"
#include "hil/emulate/emulated_device.hpp"

namespace drydock::emulate {

/// A value of a node's object dictionary: a number of 1, 2 or 4 bytes, or a text.
struct CanopenObject {
  std::uint32_t value = 0;
  std::uint8_t size = 4;
  std::string_view text = {};  ///< not empty: VISIBLE_STRING; outlives the node
};

/// What a server reads and writes.
class CanopenDictionary {
 public:
  struct Found {
    CanopenObject object;
    std::uint32_t code = 0;  ///< of the abort; 0: none
  };
  virtual ~CanopenDictionary() = default;
  virtual Found read_entry(const wire::canopen::ObjectEntry& entry) const = 0;
  /// The code of the abort; 0: written.
  virtual std::uint32_t write_entry(const wire::canopen::SdoWrite& request, Stamp now,
                                    Wire& out) = 0;
};

/// SDO server of a node (CiA 301, 7.2.4): expedited and segmented transfers, one at a time. A read
/// in blocks is refused, or answered without blocks where its client allows that.
class CanopenSdoServer {
 public:
  explicit CanopenSdoServer(std::uint8_t node) : node_(node) {}

  void restart() { reading_ = {}, writing_.reset(); }
  /// False: the frame is no request to this node.
  bool receive(const wire::CanFrame& frame, CanopenDictionary& dictionary, Stamp now, Wire& out);

 private:
  struct Writing {
    wire::canopen::SdoWrite request;
    bool toggle = false;
  };
  using Answer = std::optional<wire::CanFrame>;

  wire::CanFrame abort(const wire::canopen::ObjectEntry& entry, std::uint32_t code);
  wire::CanFrame read(const wire::canopen::ObjectEntry& entry, CanopenDictionary& dictionary);
  Answer serve(const wire::canopen::SdoLongRequest& request, CanopenDictionary& dictionary,
               Stamp now, Wire& out);
  wire::CanFrame next_segment(bool toggle);
  wire::CanFrame begin_write(const wire::canopen::SdoLongWrite& request);
  wire::CanFrame take(const wire::canopen::SdoSegment& segment, CanopenDictionary& dictionary,
                      Stamp now, Wire& out);

  std::uint8_t node_;
  wire::canopen::ObjectEntry entry_;  ///< of the transfer in segments
  std::string_view reading_;          ///< what is still to be sent; empty: no such transfer
  bool toggle_ = false;
  std::optional<Writing> writing_;
};

}  // namespace drydock::emulate
