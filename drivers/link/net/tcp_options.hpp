#pragma once

#include <boost/asio/ip/tcp.hpp>

namespace drydock::link {

/// Both ends of a TCP link: what is written leaves at once, and a peer that answers nothing for 5 s
/// (cable pulled, power off) is gone, whether bytes wait for it or not.
void set_up(boost::asio::ip::tcp::socket& socket);

}  // namespace drydock::link
