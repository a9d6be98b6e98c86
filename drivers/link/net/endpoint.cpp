#include "drivers/link/net/endpoint.hpp"

#include <boost/asio/io_context.hpp>

namespace drydock::link {
namespace {

template <class Protocol>
boost::system::result<typename Protocol::endpoint, OpenError> resolve(const Uri& uri) {
  const HostAndPort address = host_and_port(uri.target);
  asio::io_context here;
  typename Protocol::resolver resolver(here);
  boost::system::error_code error;
  const auto found = resolver.resolve(address.host, address.port, error);
  if (error || found.empty())
    return OpenError{error, "cannot find the host " + address.host + ": " + error.message()};
  return found.begin()->endpoint();
}

}  // namespace

HostAndPort host_and_port(const std::string& target) {
  const std::size_t colon = target.rfind(':');
  std::string host = target.substr(0, colon);
  if (host.size() > 2 && host.front() == '[' && host.back() == ']')
    host = host.substr(1, host.size() - 2);
  return {host, target.substr(colon + 1)};
}

boost::system::result<asio::ip::tcp::endpoint, OpenError> tcp_endpoint(const Uri& uri) {
  return resolve<asio::ip::tcp>(uri);
}

boost::system::result<asio::ip::udp::endpoint, OpenError> udp_endpoint(const Uri& uri) {
  return resolve<asio::ip::udp>(uri);
}

}  // namespace drydock::link
