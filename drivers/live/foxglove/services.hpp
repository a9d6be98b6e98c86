#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "drivers/live/foxglove/foxglove.hpp"

/// What a client may ask the server to do: the "services" of the Foxglove WebSocket protocol, with
/// JSON both ways. Specification: github.com/foxglove/ws-protocol, docs/spec.md.
namespace drydock::live {

/// JSON, or why not: one line.
using ServiceAnswer = std::variant<std::string, Refused>;

/// `request` and `response` are JSON schemas of objects. `serve` is called in the server's thread;
/// it answers once, at once or later, and its text is gone when it returns.
struct Service {
  using Answered = std::function<void(const ServiceAnswer&)>;
  std::string name, type, request, response;
  std::function<void(std::string_view request, Answered)> serve;
};

/// Their numbers are their places, from 1.
std::string advertise_services(std::span<const Service> services);

struct ServiceCall {
  std::uint32_t service = 0, call = 0;
  std::string_view encoding, request;  ///< in the client's message
};

/// A binary message from a client: opcode 2. Never throws.
std::variant<ServiceCall, Refused> parse_call(std::string_view message);

/// Opcode 3.
std::string service_response(const ServiceCall& call, std::string_view json);
std::string service_failure(const ServiceCall& call, std::string_view why);

}  // namespace drydock::live
