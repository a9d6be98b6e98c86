#pragma once

#include <algorithm>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>

namespace drydock::link {

/// Both ends of a TCP link: what is written leaves at once, and a peer that answers nothing for 5 s
/// (cable pulled, power off) is gone, whether bytes wait for it or not.
void set_up(boost::asio::ip::tcp::socket& socket);

/// Of a name with more addresses only the first ones are tried.
constexpr std::size_t most_addresses = 32;

/// How long an address may stay silent before the next one of `addresses` is tried. A device opens
/// a link anew that brought nothing for 10 s, and would begin with the first address again: so all
/// have their turn within 8 s.
constexpr std::chrono::milliseconds limit_per_address(std::size_t addresses) {
  constexpr std::chrono::milliseconds of_one{2000}, of_all{8000};
  return std::min(of_one, of_all / static_cast<int>(std::max<std::size_t>(addresses, 1)));
}

}  // namespace drydock::link
