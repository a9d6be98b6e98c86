#pragma once

#include "drivers/wire/nmea0183/nmea0183.hpp"
#include "hil/emulate/gnss/gnss_epoch.hpp"

/// The sentences of an epoch; talker GP.
namespace drydock::emulate {

wire::Rmc rmc(const GnssEpoch& epoch);
wire::Gga gga(const GnssEpoch& epoch);
wire::Vtg vtg(const GnssEpoch& epoch);
wire::Gsa gsa(const GnssEpoch& epoch);
wire::Gll gll(const GnssEpoch& epoch);
wire::Zda zda(const GnssEpoch& epoch);

inline constexpr std::size_t gsv_satellites = 4;  ///< in one sentence
int gsv_sentences(const GnssEpoch& epoch);
wire::Gsv gsv(const GnssEpoch& epoch, int number);  ///< from 1

/// Calls `send(sentence)` for the sentences of a group GSV.
template <class Send>
void each_gsv(const GnssEpoch& epoch, Send&& send) {
  for (int number = 1; number <= gsv_sentences(epoch); ++number) send(gsv(epoch, number));
}

}  // namespace drydock::emulate
