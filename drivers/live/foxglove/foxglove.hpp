#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// The Foxglove WebSocket protocol, version 1, server side: JSON texts for control, binary messages
/// for data. Specification: github.com/foxglove/ws-protocol, docs/spec.md.
namespace drydock::live {

/// Both are identical on the wire. The first is the name in Foxglove's SDK, the second the
/// protocol's old name.
inline constexpr std::array<std::string_view, 2> subprotocols{"foxglove.sdk.v1",
                                                              "foxglove.websocket.v1"};

struct Channel {
  std::uint32_t id = 0;
  std::string topic, encoding, schema_name, schema, schema_encoding;
};

/// `obeys` means that the server has services, with JSON (services.hpp).
std::string server_info(std::string_view name, std::string_view session, bool obeys);
std::string advertise(std::span<const Channel> channels);
/// `level`: 0 information, 1 warning, 2 error.
std::string status(int level, std::string_view text);

/// Precedes the payload of a data message: opcode 1, the client's subscription, time in ns.
using DataHead = std::array<std::uint8_t, 13>;
DataHead data_head(std::uint32_t subscription, std::uint64_t time_ns);

struct Subscription {
  std::uint32_t id = 0, channel = 0;
};
struct Subscribe {
  std::vector<Subscription> subscriptions;
};
struct Unsubscribe {
  std::vector<std::uint32_t> ids;
};
/// A request that was not understood. `why` is for the client.
struct Refused {
  std::string why;
};
using Request = std::variant<Subscribe, Unsubscribe, Refused>;

/// Parses a text from a client. Never throws.
Request parse_request(std::string_view text);

}  // namespace drydock::live
