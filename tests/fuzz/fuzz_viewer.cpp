#include <boost/asio/buffer.hpp>
#include <boost/beast/http.hpp>
#include <cstdlib>
#include <string>

#include "drivers/live/foxglove/access.hpp"
#include "drivers/live/foxglove/services.hpp"
#include "hil/control/request/fault_requests.hpp"

namespace http = boost::beast::http;
using namespace drydock::live;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

std::string text_of(boost::beast::string_view view) { return {view.data(), view.size()}; }

/// Reads a request as the server does. A client without permission must be refused.
void as_http(const std::uint8_t* data, std::size_t size) {
  http::request_parser<http::string_body> parser;
  boost::system::error_code error;
  parser.eager(true);
  parser.put(boost::asio::buffer(data, size), error);
  if (!parser.is_header_done()) return;
  const auto& request = parser.get();
  const std::string target = text_of(request.target()), host = text_of(request[http::field::host]),
                    origin = text_of(request[http::field::origin]);
  const Knock knock{target, host, origin};
  if (!refusal(knock, "")) {
    const bool by_address = host.find_first_not_of("0123456789.:") == std::string::npos;
    require(host.starts_with("localhost") || host.starts_with("[::1]") ||
            (by_address && host.starts_with("127.")));
    require(origin != "null");
  }
  const bool knows_it = target.find("token=secret") != std::string::npos;
  require(refusal(knock, "secret").has_value() || knows_it);
  require(path_of(target).size() <= target.size());
}

/// A request for a fault. An order for the bench must consist of complete lines of JSON.
void as_fault(std::string_view request) {
  for (const auto& asked : {drydock::control::order_of_set_request(request),
                            drydock::control::order_of_clear_request(request)}) {
    if (const auto* order = std::get_if<std::string>(&asked)) {
      require(order->starts_with("{") && order->ends_with("}") && order->size() < 65'536);
      require(order->find('\n') == std::string::npos);
    } else {
      require(!std::get<Refused>(asked).why.empty());
    }
  }
}

void as_call(std::string_view message) {
  const auto asked = parse_call(message);
  const auto* call = std::get_if<ServiceCall>(&asked);
  if (call == nullptr) return require(!std::get<Refused>(asked).why.empty());
  require(13 + call->encoding.size() + call->request.size() == message.size());
  require(service_failure(*call, call->request).starts_with("{"));
  as_fault(call->request);
}

}  // namespace

/// Input on the port of a live page: the text of a viewer, its call of a service, the head of an
/// HTTP request.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto request = parse_request({reinterpret_cast<const char*>(data), size});
  if (const auto* refused = std::get_if<Refused>(&request)) {
    require(!refused->why.empty() && refused->why.size() < 200);
    require(!status(2, refused->why).empty());
  }
  if (const auto* wanted = std::get_if<Subscribe>(&request))
    require(wanted->subscriptions.size() <= size);
  as_call({reinterpret_cast<const char*>(data), size});
  as_fault({reinterpret_cast<const char*>(data), size});
  as_http(data, size);
  return 0;
}
