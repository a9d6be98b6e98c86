#include "drivers/link/reading.hpp"

#include <array>

#include "drivers/link/opening.hpp"

namespace drydock::link {
namespace {

constexpr std::size_t longest_read = 4096;

asio::awaitable<ErrorCode> each_read(ByteLink& link, auto on_read) {
  std::array<std::uint8_t, longest_read> buffer;
  for (;;) {
    const auto received = co_await link.read(buffer);
    if (!received) co_return received.error();
    const wire::Bytes bytes{buffer.data(), received->size};
    if constexpr (std::is_void_v<decltype(on_read(bytes, received->at))>)
      on_read(bytes, received->at);
    else
      co_await on_read(bytes, received->at);
  }
}

asio::awaitable<ErrorCode> each_read(FrameLink& link, auto on_read) {
  for (;;) {
    const auto received = co_await link.read();
    if (!received) co_return received.error();
    if (received->own) continue;
    if constexpr (std::is_void_v<decltype(on_read(received->frame, received->at))>)
      on_read(received->frame, received->at);
    else
      co_await on_read(received->frame, received->at);
  }
}

}  // namespace

template <class Link>
asio::awaitable<ErrorCode> read_until_lost(Link& link, Heard<Link> heard) {
  return each_read(link, std::move(heard));
}

template <class Link>
asio::awaitable<ErrorCode> relay_until_lost(Link& link, Relay<Link> relay) {
  return each_read(link, std::move(relay));
}

template asio::awaitable<ErrorCode> read_until_lost(ByteLink&, Heard<ByteLink>);
template asio::awaitable<ErrorCode> read_until_lost(FrameLink&, Heard<FrameLink>);
template asio::awaitable<ErrorCode> relay_until_lost(ByteLink&, Relay<ByteLink>);
template asio::awaitable<ErrorCode> relay_until_lost(FrameLink&, Relay<FrameLink>);

}  // namespace drydock::link
