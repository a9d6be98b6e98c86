#include "drivers/wire/canopen/canopen_sdo.hpp"

#include "drivers/wire/bytes.hpp"
#include "drivers/wire/canopen/canopen.hpp"

namespace drydock::wire::canopen {

namespace {

// Command specifiers, bits 5 to 7 of byte 0. Each direction has its own numbers.
constexpr unsigned client_download = 1, client_upload = 2;
constexpr unsigned server_upload = 2, server_download = 3;
constexpr unsigned client_segment = 0, client_next_segment = 3, abort_transfer = 4;
constexpr std::uint32_t specifier_not_valid = 0x05040001;
constexpr unsigned expedited = 0x02, size_indicated = 0x01;

unsigned specifier(const CanFrame& frame) { return frame.data[0] >> 5; }

ObjectEntry entry_of(const CanFrame& frame) {
  return {load_le<std::uint16_t>(frame.data, 1), frame.data[3]};
}

struct Data {
  std::uint32_t value;
  std::uint8_t size;
  bool sized;
};

/// Bytes after the size are undefined and may have any value.
std::optional<Data> expedited_data(const CanFrame& frame) {
  const unsigned command = frame.data[0];
  if ((command & expedited) == 0) return std::nullopt;
  const bool sized = (command & size_indicated) != 0;
  const unsigned unused = sized ? command >> 2 & 3 : 0;
  const auto value = load_le<std::uint32_t>(frame.data, 4) & 0xFFFFFFFFu >> 8 * unused;
  return Data{value, static_cast<std::uint8_t>(4 - unused), sized};
}

CanFrame sdo_frame(std::uint32_t id, unsigned command, const ObjectEntry& entry,
                   std::uint32_t data = 0) {
  CanFrame frame;
  frame.id = id;
  frame.size = 8;
  frame.data[0] = static_cast<std::uint8_t>(command);
  store_le<std::uint16_t>(frame.data, 1, entry.index);
  frame.data[3] = entry.subindex;
  store_le<std::uint32_t>(frame.data, 4, data);
  return frame;
}

unsigned with_data(unsigned which, std::uint8_t size) {
  const unsigned unused = 4u - std::clamp<unsigned>(size, 1, 4);
  return which << 5 | unused << 2 | expedited | size_indicated;
}

}  // namespace

std::optional<SdoRequest> decode_sdo_request(const CanFrame& frame) {
  const auto node = node_above(frame, sdo_request_base);
  if (!node || frame.size != 8) return std::nullopt;
  if (specifier(frame) == client_upload) return SdoRead{*node, entry_of(frame)};
  if (specifier(frame) != client_download) return std::nullopt;
  const auto data = expedited_data(frame);
  if (!data) return std::nullopt;
  return SdoWrite{*node, entry_of(frame), data->value, data->size, data->sized};
}

std::optional<SdoAbort> refuse_other_request(const CanFrame& frame) {
  const auto node = node_above(frame, sdo_request_base);
  if (!node || specifier(frame) == abort_transfer || decode_sdo_request(frame)) return std::nullopt;
  const bool names_no_entry =
      specifier(frame) == client_segment || specifier(frame) == client_next_segment;
  return SdoAbort{*node, names_no_entry ? ObjectEntry{} : entry_of(frame), specifier_not_valid};
}

std::optional<SdoResponse> decode_sdo_response(const CanFrame& frame) {
  const auto node = node_above(frame, sdo_response_base);
  if (!node || frame.size != 8) return std::nullopt;
  const ObjectEntry entry = entry_of(frame);
  switch (specifier(frame)) {
    case server_download: return SdoWritten{*node, entry};
    case abort_transfer: return SdoAbort{*node, entry, load_le<std::uint32_t>(frame.data, 4)};
    case server_upload: break;
    default: return std::nullopt;
  }
  const auto data = expedited_data(frame);
  if (!data) return std::nullopt;
  return SdoValue{*node, entry, data->value, data->size};
}

CanFrame encode(const SdoRead& m) {
  return sdo_frame(sdo_request_base + m.node, client_upload << 5, m.entry);
}

CanFrame encode(const SdoWrite& m) {
  return sdo_frame(sdo_request_base + m.node, with_data(client_download, m.size), m.entry, m.value);
}

CanFrame encode(const SdoValue& m) {
  return sdo_frame(sdo_response_base + m.node, with_data(server_upload, m.size), m.entry, m.value);
}

CanFrame encode(const SdoWritten& m) {
  return sdo_frame(sdo_response_base + m.node, server_download << 5, m.entry);
}

CanFrame encode(const SdoAbort& m) {
  return sdo_frame(sdo_response_base + m.node, abort_transfer << 5, m.entry, m.code);
}

}  // namespace drydock::wire::canopen
