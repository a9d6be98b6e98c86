#pragma once

#include "drivers/wire/codec.hpp"

/// The checksums and forms of frames again, written from the documents and not from the scanners.
namespace drydock::wire::testing {

bool sound_sentence(Bytes frame);
bool sound_ubx(Bytes frame);
bool sound_ubx_nmea(Bytes frame);
bool sound_water_linked(Bytes frame);
bool sound_water_linked_json(Bytes frame);
bool sound_pd0(Bytes frame);
bool sound_pd4_or_pd5(Bytes frame);
bool sound_pd6(Bytes frame);
bool sound_ad2cp(Bytes frame);
bool sound_wayfinder(Bytes frame);
bool sound_mavlink(Bytes frame);

}  // namespace drydock::wire::testing
