#include "drivers/live/foxglove/services.hpp"

#include <array>
#include <boost/endian/conversion.hpp>
#include <nlohmann/json.hpp>

namespace drydock::live {

namespace {

using nlohmann::json;

constexpr char call_opcode = 2, response_opcode = 3;
constexpr std::size_t call_head = 13;  ///< opcode, service, call, length of the encoding's name

json shape(const std::string& name, const std::string& schema) {
  return {{"encoding", "json"},
          {"schemaName", name},
          {"schemaEncoding", "jsonschema"},
          {"schema", schema}};
}

std::uint32_t number_at(std::string_view message, std::size_t at) {
  std::array<unsigned char, 4> bytes{};
  message.copy(reinterpret_cast<char*>(bytes.data()), bytes.size(), at);
  return boost::endian::load_little_u32(bytes.data());
}

void append(std::string& message, std::uint32_t number) {
  std::array<unsigned char, 4> bytes{};
  boost::endian::store_little_u32(bytes.data(), number);
  message.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace

std::string advertise_services(std::span<const Service> services) {
  json list = json::array();
  for (const auto& service : services)
    list.push_back({{"id", list.size() + 1},
                    {"name", service.name},
                    {"type", service.type},
                    {"request", shape(service.type + "_Request", service.request)},
                    {"response", shape(service.type + "_Response", service.response)}});
  return json{{"op", "advertiseServices"}, {"services", list}}.dump();
}

std::variant<ServiceCall, Refused> parse_call(std::string_view message) {
  if (message.empty() || message.front() != call_opcode)
    return Refused{"a binary message is a service call: opcode 2"};
  if (message.size() < call_head) return Refused{"a service call has 13 bytes before its request"};
  const ServiceCall call{number_at(message, 1), number_at(message, 5), {}, {}};
  const std::string_view rest = message.substr(call_head);
  const std::size_t encoding = number_at(message, 9);
  if (encoding > rest.size()) return Refused{"a service call ends in the name of its encoding"};
  return ServiceCall{call.service, call.call, rest.substr(0, encoding), rest.substr(encoding)};
}

std::string service_response(const ServiceCall& call, std::string_view json) {
  constexpr std::string_view encoding = "json";
  std::string message(1, response_opcode);
  append(message, call.service);
  append(message, call.call);
  append(message, encoding.size());
  message += encoding;
  message += json;
  return message;
}

std::string service_failure(const ServiceCall& call, std::string_view why) {
  return json{{"op", "serviceCallFailure"},
              {"serviceId", call.service},
              {"callId", call.call},
              {"message", why}}
      .dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace drydock::live
