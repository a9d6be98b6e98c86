#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/live/foxglove/foxglove.hpp"

/// Requests that a client may send to the server: the "services" of the Foxglove WebSocket
/// protocol, with JSON in both directions. Specification: github.com/foxglove/ws-protocol,
/// docs/spec.md.
namespace drydock::live {

/// JSON, or the reason of the refusal in one line.
using ServiceAnswer = std::variant<std::string, Refused>;

/// `request` and `response` are JSON schemas of objects. The server's thread calls `serve`. It
/// answers exactly once, at once or later; its text is valid only during the call.
struct Service {
  using Answered = std::function<void(const ServiceAnswer&)>;
  std::string name, type, request, response;
  std::function<void(std::string_view request, Answered)> serve;
};

/// The number of a service is its index plus 1.
std::string advertise_services(std::span<const Service> services);

struct ServiceCall {
  std::uint32_t service = 0, call = 0;
  std::string_view encoding, request;  ///< views into the client's message
};

/// Parses a binary message from a client: opcode 2. Never throws.
std::variant<ServiceCall, Refused> parse_call(std::string_view message);

/// Encodes an answer: opcode 3.
std::string service_response(const ServiceCall& call, std::string_view json);
std::string service_failure(const ServiceCall& call, std::string_view why);

}  // namespace drydock::live
