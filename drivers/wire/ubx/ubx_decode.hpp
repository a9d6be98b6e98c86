#pragma once

#include <optional>

#include "drivers/wire/ubx/ubx.hpp"
#include "drivers/wire/ubx/ubx_frame.hpp"

namespace drydock::wire {

/// Decodes a UBX frame into a variant with at least the messages of Ubx.
template <class Variant>
std::optional<Variant> decode_ubx(Bytes frame) {
  if (frame.size() < ubx::overhead) return std::nullopt;
  const auto class_and_id = load_be<std::uint16_t>(frame, 2);
  const Bytes payload = frame.subspan(ubx::header_size, frame.size() - ubx::overhead);
  const auto is_it = [=]<class M>() { return M::class_and_id == class_and_id; };
  return read_one_of<Variant>(UbxMessages{}, is_it, payload);
}

}  // namespace drydock::wire
