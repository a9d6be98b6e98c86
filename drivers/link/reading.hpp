#pragma once

#include <functional>

#include "drivers/link/traffic.hpp"

namespace drydock::link {

template <class Link>
using Heard = std::function<void(const typename Traffic<Link>::Item&, Stamp)>;
template <class Link>
using Relay = std::function<asio::awaitable<void>(const typename Traffic<Link>::Item&, Stamp)>;

/// Reads until the link is lost or closed, and returns the reason. `heard` gets every read with its
/// time; echoes of own frames are left out. The link must outlive the reading.
template <class Link>
asio::awaitable<boost::system::error_code> read_until_lost(Link& link, Heard<Link> heard);

/// The same, but the next read waits until `relay` has ended.
template <class Link>
asio::awaitable<boost::system::error_code> relay_until_lost(Link& link, Relay<Link> relay);

extern template asio::awaitable<boost::system::error_code> read_until_lost(ByteLink&,
                                                                           Heard<ByteLink>);
extern template asio::awaitable<boost::system::error_code> read_until_lost(FrameLink&,
                                                                           Heard<FrameLink>);
extern template asio::awaitable<boost::system::error_code> relay_until_lost(ByteLink&,
                                                                            Relay<ByteLink>);
extern template asio::awaitable<boost::system::error_code> relay_until_lost(FrameLink&,
                                                                            Relay<FrameLink>);

}  // namespace drydock::link
