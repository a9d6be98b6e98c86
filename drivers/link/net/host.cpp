#include "drivers/link/net/host.hpp"

#include <boost/asio/experimental/awaitable_operators.hpp>
#include <set>
#include <utility>

namespace drydock::link {
namespace {

constexpr std::chrono::milliseconds own_name_limit{1000};

/// True once for each name.
bool is_first_call(const std::string& host) {
  static std::mutex mutex;
  static std::set<std::string> seen;
  const std::lock_guard lock(mutex);
  return seen.insert(host).second;
}

}  // namespace

Host::Host(const asio::any_io_executor& executor, std::string name, LookupPatience patience)
    : name_(std::move(name)), patience_(patience), bell_(executor), timer_(executor) {}

Task<Addresses> Host::addresses() {
  if (const auto address = address_in_numbers(name_)) co_return Addresses{*address};
  const auto lookup = Lookup::of(name_);
  Addresses last_good = last_good_answer(name_);
  co_await answered(*lookup, last_good.empty() ? patience_.first : patience_.again);
  if (stopped_) co_return ErrorCode(asio::error::operation_aborted);
  auto answer = lookup->answer();
  if (answer && *answer) co_return std::move(*answer);
  if (!last_good.empty()) co_return last_good;
  co_return answer ? answer->error() : no_answer();
}

asio::awaitable<void> Host::answered(const Lookup& lookup, std::chrono::milliseconds limit) {
  using namespace asio::experimental::awaitable_operators;
  Descriptor bell = lookup.bell();
  boost::system::error_code error;
  if (!stopped_ && bell) bell_.assign(bell.release(), error);
  if (!bell_.is_open()) co_return;
  timer_.expires_after(limit);
  co_await (bell_.async_wait(asio::posix::stream_descriptor::wait_read, as_outcome) ||
            timer_.async_wait(as_outcome));
  bell_.close(error);
}

void Host::stop() {
  stopped_ = true;
  boost::system::error_code already_gone;
  bell_.close(already_gone);
}

std::optional<asio::ip::address> address_in_numbers(const std::string& host) {
  boost::system::error_code is_name;
  const auto address = asio::ip::make_address(host, is_name);
  return is_name ? std::nullopt : std::optional(address);
}

Lookup::Answer own_addresses(const std::string& host) {
  if (const auto address = address_in_numbers(host)) return Addresses{*address};
  if (Addresses last_good = last_good_answer(host); !last_good.empty()) return last_good;
  const auto lookup = Lookup::of(host);
  if (is_first_call(host)) lookup->wait(own_name_limit);
  return lookup->answer().value_or(no_answer());
}

}  // namespace drydock::link
