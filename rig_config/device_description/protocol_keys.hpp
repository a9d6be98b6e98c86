#pragma once

#include "drivers/wire/described/plan.hpp"
#include "rig_config/load.hpp"
#include "rig_config/toml/node.hpp"

namespace drydock::rig_config {

/// Reads what [protocol] says of all its messages: checksums, ends, stuffing, decimals. The form is
/// in `plan` already.
void read_protocol_keys(const Node& protocol, wire::described::Plan& plan, const std::string& file,
                        Problems& problems);

/// The order of the bytes and words of a number. The highest byte A of four stands first, last, or
/// in one of the two ways of Modbus registers: `CDAB`, `BADC`.
struct NumberOrder {
  bool big_endian = false, low_word_first = false;
};

/// Of the key `order` of this table, else `usual`.
NumberOrder order_of(const Node& table, NumberOrder usual = {});

/// What stands behind a field of a text, unless the field says otherwise.
char separator_of(const Node& protocol);

}  // namespace drydock::rig_config
