#pragma once

#include <optional>
#include <string_view>

#include "drivers/wire/codec.hpp"
#include "drivers/wire/message_list.hpp"
#include "drivers/wire/ubx/ubx_nav.hpp"
#include "drivers/wire/ubx/ubx_rxm.hpp"
#include "drivers/wire/ubx/ubx_satellites.hpp"
#include "drivers/wire/ubx/ubx_solution.hpp"
#include "drivers/wire/ubx/ubx_time.hpp"

namespace drydock::wire {

using UbxMessages = MessageList<NavPvt, NavSat, NavEoe, NavSig, RxmRawx, RxmSfrbx, NavDop, NavSol,
                                NavPosllh, NavVelned, NavStatus, NavSvinfo, NavTimeGps, NavTimeUtc>;

/// u-blox binary: B5 62, class, id, length (u16), payload, Fletcher-8 over class to payload.
struct Ubx {
  static constexpr std::string_view name = "ubx";
  /// RXM-RAWX with 255 measurements. In any other message a payload longer than `longest_payload`
  /// means a damaged length. The stream must not wait for bytes that never come.
  static constexpr std::size_t max_frame = 16 + 255 * 32 + 8;
  static constexpr std::size_t longest_payload = 4096;  ///< NAV-SIG with 255 signals: 4088
  using Message = UbxMessages::Variant;

  static Scan scan(Bytes bytes);
  static std::optional<Message> decode(Bytes frame);
};

}  // namespace drydock::wire
