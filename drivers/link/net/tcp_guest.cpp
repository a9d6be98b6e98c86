#include "drivers/link/net/tcp_guest.hpp"

#include <linux/sockios.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <algorithm>
#include <boost/asio/buffer.hpp>
#include <boost/asio/experimental/awaitable_operators.hpp>

#include "drivers/link/net/tcp_options.hpp"

namespace drydock::link {
namespace {

constexpr std::chrono::seconds longest_pause{1};

}  // namespace

TcpGuest::TcpGuest(asio::ip::tcp::socket socket, std::shared_ptr<io::Signal> changed,
                   std::uint64_t number)
    : socket_(std::move(socket)),
      changed_(std::move(changed)),
      patience_(socket_.get_executor()),
      number_(number) {
  set_up(socket_);
  boost::system::error_code error;
  socket_.native_non_blocking(true, error);
}

asio::awaitable<void> TcpGuest::listen() {
  while (here_) {
    if (begin_ < end_) {
      co_await changed_->wait();
      continue;
    }
    const auto [error, size] = co_await socket_.async_read_some(asio::buffer(heard_), as_outcome);
    if (error) break;
    begin_ = 0;
    end_ = size;
    said_at_ = now();
    changed_->notify();
  }
  leave();
}

asio::awaitable<void> TcpGuest::deliver() {
  using namespace asio::experimental::awaitable_operators;
  while (here_) {
    if (waiting_.empty()) {
      if (finishing_) leave();
      if (here_) co_await changed_->wait();
      continue;
    }
    const auto next = waiting_.array_one();
    patience_.expires_after(longest_pause);
    const auto first =
        co_await (socket_.async_write_some(asio::buffer(next.first, next.second), as_outcome) ||
                  patience_.async_wait(as_outcome));
    const auto* written = std::get_if<0>(&first);
    if (written == nullptr || std::get<0>(*written)) {
      throw_out();
    } else {
      waiting_.erase_begin(std::get<1>(*written));
      const bool is_slow =
          full_since_ && std::chrono::steady_clock::now() - *full_since_ > longest_pause;
      if (is_slow) throw_out();
      changed_->notify();
    }
  }
}

std::size_t TcpGuest::give(std::span<const std::uint8_t> bytes) {
  const std::size_t sent = waiting_.empty() ? send_now(bytes) : 0;
  const auto rest = bytes.subspan(sent);
  const auto kept = rest.first(std::min(rest.size(), here_ ? waiting_.reserve() : 0));
  if (kept.size() == rest.size())
    full_since_.reset();
  else if (!full_since_)
    full_since_ = std::chrono::steady_clock::now();
  if (kept.empty()) return sent;
  waiting_.insert(waiting_.end(), kept.begin(), kept.end());
  changed_->notify();
  return sent + kept.size();
}

std::size_t TcpGuest::send_now(std::span<const std::uint8_t> bytes) {
  const ssize_t sent = ::send(socket_.native_handle(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
  if (sent >= 0) return static_cast<std::size_t>(sent);
  if (errno != EAGAIN && errno != EINTR) leave();
  return 0;
}

void TcpGuest::take(std::size_t size) {
  begin_ += size;
  if (begin_ == end_) changed_->notify();
}

/// It does not read. A reset tells it so, and what the kernel has still to send goes with it.
void TcpGuest::throw_out() {
  if (!here_) return;
  int unheard = 0;
  if (::ioctl(socket_.native_handle(), SIOCOUTQ, &unheard) == 0)
    dropped_ += static_cast<std::uint64_t>(unheard);
  boost::system::error_code already_gone;
  socket_.set_option(asio::socket_base::linger(true, 0), already_gone);
  leave();
}

void TcpGuest::leave() {
  if (!std::exchange(here_, false)) return;
  dropped_ += waiting_.size();
  boost::system::error_code already_gone;
  socket_.close(already_gone);
  patience_.cancel();
  changed_->notify();
}

void TcpGuest::finish() {
  finishing_ = true;
  if (waiting_.empty()) leave();
}

}  // namespace drydock::link
