#include "hil/control/control_socket.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/as_tuple.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <filesystem>
#include <vector>

#include "drivers/link/link.hpp"
#include "drivers/link/private_folder.hpp"

namespace drydock::control {

namespace {

namespace asio = boost::asio;
namespace fs = std::filesystem;
using Local = asio::local::stream_protocol;

constexpr auto outcome = asio::as_tuple(asio::use_awaitable);
constexpr std::chrono::seconds patience{5};  ///< limit for a client that connects and sends nothing
constexpr std::chrono::seconds quick{1};     ///< limit for an answer when drivers run on the same
                                             ///< thread
constexpr std::size_t most_callers = 16;
/// To one more, as an answer to whatever it asks.
constexpr std::string_view busy =
    R"({"ok":false,"lines":["the bench runs, but 16 others are at its control socket: try again"]})"
    "\n";

constexpr std::size_t longest_path = sizeof(sockaddr_un::sun_path) - 1;

/// The name under which a socket is bound before it is renamed.
std::string name_while_new(const std::string& path) {
  return path + "." + std::to_string(::getpid()) + ".new";
}
constexpr std::size_t longest_name_while_new = std::string_view(".4194304.new").size();

bool is_too_long(const std::string& path) {
  return path.size() + longest_name_while_new > longest_path;
}

/// FNV-1a, 64 bits: the same in each program and version.
std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

bool somebody_answers(const std::string& path) {
  asio::io_context io;
  Local::socket socket(io);
  boost::system::error_code refused;
  socket.connect(Local::endpoint(path), refused);
  return !refused;
}

void close_when_over(asio::steady_timer& time, const std::shared_ptr<Local::socket>& socket) {
  time.async_wait([socket](const boost::system::error_code& ended) {
    boost::system::error_code already_gone;
    if (!ended) socket->close(already_gone);
  });
}

}  // namespace

std::string control_path(std::string_view rig_name) {
  std::string name(rig_name);
  std::ranges::replace(name, '/', '_');
  std::string path = link::pty_path(name + ".control");
  if (!is_too_long(path)) return path;
  return link::pty_path(fmt::format("{:016x}.control", hash_of(name)));
}

/// The coroutines share it.
struct ControlSocket::House : std::enable_shared_from_this<House> {
  House(const asio::any_io_executor& executor, std::string where, Answer answers)
      : acceptor(executor), path(std::move(where)), answer(std::move(answers)) {}

  boost::system::error_code listen();
  asio::awaitable<void> receive_callers();
  asio::awaitable<void> serve(std::shared_ptr<Local::socket> caller);
  void close();

  Local::acceptor acceptor;
  std::string path;
  Answer answer;
  std::vector<std::weak_ptr<Local::socket>> callers;
};

/// Binds under another name, sets the mode, then renames: the socket never exists with a mode that
/// lets other users in.
boost::system::error_code ControlSocket::House::listen() {
  const std::string fresh = name_while_new(path);
  ::unlink(fresh.c_str());
  boost::system::error_code error;
  acceptor.open(Local(), error);
  if (!error) acceptor.bind(Local::endpoint(fresh), error);
  if (!error && ::chmod(fresh.c_str(), 0600) != 0)
    error.assign(errno, boost::system::system_category());
  if (!error) acceptor.listen(static_cast<int>(most_callers), error);
  if (!error && ::rename(fresh.c_str(), path.c_str()) != 0)
    error.assign(errno, boost::system::system_category());
  if (error) ::unlink(fresh.c_str());
  return error;
}

asio::awaitable<void> ControlSocket::House::receive_callers() {
  const auto self = shared_from_this();
  while (acceptor.is_open()) {
    auto [error, socket] = co_await acceptor.async_accept(outcome);
    if (error) co_return;
    std::erase_if(callers, [](const auto& caller) { return caller.expired(); });
    if (callers.size() >= most_callers) {
      boost::system::error_code ignored;
      socket.non_blocking(true, ignored);
      socket.write_some(asio::buffer(busy), ignored);
      continue;
    }
    auto caller = std::make_shared<Local::socket>(std::move(socket));
    callers.push_back(caller);
    asio::co_spawn(acceptor.get_executor(), serve(std::move(caller)), asio::detached);
  }
}

asio::awaitable<void> ControlSocket::House::serve(std::shared_ptr<Local::socket> caller) {
  const auto self = shared_from_this();
  asio::steady_timer silence(caller->get_executor(), patience);
  close_when_over(silence, caller);
  std::string request;
  const auto [error, size] = co_await asio::async_read_until(
      *caller, asio::dynamic_buffer(request, longest_line), '\n', outcome);
  if (error || !acceptor.is_open()) co_return;
  const std::string line = answer(std::string_view(request).substr(0, size - 1)) + "\n";
  co_await asio::async_write(*caller, asio::buffer(line), outcome);
}

void ControlSocket::House::close() {
  boost::system::error_code already_gone;
  if (acceptor.is_open()) ::unlink(path.c_str());
  acceptor.close(already_gone);
  for (const auto& weak : callers)
    if (const auto caller = weak.lock()) caller->close(already_gone);
}

boost::system::result<std::unique_ptr<ControlSocket>, std::string> ControlSocket::open(
    const asio::any_io_executor& executor, const std::string& path, Answer answer) {
  if (is_too_long(path))
    return path + " is too long for a socket; set XDG_RUNTIME_DIR to a shorter path";
  if (auto why = link::make_private_folder(fs::path(path).parent_path().string()); !why.empty())
    return why;
  if (somebody_answers(path)) return "another program answers at " + path;
  auto house = std::make_shared<House>(executor, path, std::move(answer));
  if (const auto error = house->listen())
    return "cannot listen at " + path + ": " + error.message();
  asio::co_spawn(executor, house->receive_callers(), asio::detached);
  return std::unique_ptr<ControlSocket>(new ControlSocket(std::move(house)));
}

ControlSocket::~ControlSocket() { house_->close(); }

boost::system::result<std::string> ask(const std::string& path, const std::string& request) {
  if (is_too_long(path)) return make_error_code(boost::system::errc::filename_too_long);
  asio::io_context io;
  Local::socket socket(io);
  boost::system::error_code error;
  socket.connect(Local::endpoint(path), error);
  if (!error) asio::write(socket, asio::buffer(request + "\n"), error);
  if (error) return error;
  std::string answer;
  asio::read(socket, asio::dynamic_buffer(answer), error);
  if (!answer.ends_with('\n')) return error;  // a bench that is busy leaves the question unread
  answer.pop_back();
  return answer;
}

asio::awaitable<boost::system::result<std::string>> ask_soon(std::string path,
                                                             std::string request) {
  if (is_too_long(path)) co_return make_error_code(boost::system::errc::filename_too_long);
  const auto socket = std::make_shared<Local::socket>(co_await asio::this_coro::executor);
  asio::steady_timer silence(socket->get_executor(), quick);
  close_when_over(silence, socket);
  std::string answer;
  auto [error] = co_await socket->async_connect(Local::endpoint(path), outcome);
  if (error) co_return error;
  request += '\n';
  const auto [unsent, sent] = co_await asio::async_write(*socket, asio::buffer(request), outcome);
  if (unsent) co_return unsent;
  const auto [ended, size] = co_await asio::async_read_until(
      *socket, asio::dynamic_buffer(answer, ControlSocket::longest_answer), '\n', outcome);
  if (ended) co_return ended;
  answer.resize(size - 1);
  co_return answer;
}

}  // namespace drydock::control
