#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <boost/asio/co_spawn.hpp>
#include <boost/asio/io_context.hpp>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/link/link.hpp"

/// Runs links to an end in a test: a real io_context, and a limit on every wait.
namespace drydock::link::testing {

using namespace std::chrono_literals;

/// A running task. `outcome` is empty until it has ended.
template <class T>
struct Running {
  std::optional<boost::system::result<T>> outcome;
};

template <class T>
std::shared_ptr<Running<T>> start(asio::io_context& io, Task<T> task) {
  auto running = std::make_shared<Running<T>>();
  asio::co_spawn(io, std::move(task),
                 [running](std::exception_ptr, const boost::system::result<T>& outcome) {
                   running->outcome = outcome;
                 });
  return running;
}

/// Runs the context until `done()` is true. False if the time limit came first.
template <class Done>
bool run_until(asio::io_context& io, Done&& done, std::chrono::milliseconds bound = 5s) {
  const auto end = std::chrono::steady_clock::now() + bound;
  io.restart();
  while (!done())
    if (io.run_one_until(end) == 0 && !done()) return false;
  return true;
}

/// Runs everything that is ready now, and all work that follows from it. The kernel hands the bytes
/// of a pty over in a thread of its own, which on a busy machine comes some tens of ms later.
inline void settle(asio::io_context& io) {
  io.restart();
  while (io.run_for(50ms) > 0) io.restart();
}

template <class T>
boost::system::result<T> run(asio::io_context& io, Task<T> task) {
  const auto running = start(io, std::move(task));
  if (!run_until(io, [&] { return running->outcome.has_value(); }))
    return asio::error::make_error_code(asio::error::timed_out);
  return *running->outcome;
}

using Buffer = std::vector<std::uint8_t>;

inline Buffer bytes(std::string_view text) { return {text.begin(), text.end()}; }

/// Reads exactly `size` bytes. After an error, returns the bytes that came before it.
inline Task<Buffer> read_bytes(ByteLink& link, std::size_t size) {
  Buffer all(size);
  std::size_t held = 0;
  while (held < size) {
    const auto received = co_await link.read(std::span(all).subspan(held));
    if (!received) break;
    held += received->size;
  }
  all.resize(held);
  co_return all;
}

inline std::unique_ptr<ByteLink> open(asio::io_context& io, const std::string& uri, Side side) {
  auto link = open_bytes(io.get_executor(), parse_uri(uri).value(), side);
  if (!link) ADD_FAILURE() << uri << ": " << link.error().message;
  return link ? std::move(*link) : nullptr;
}

inline std::unique_ptr<FrameLink> open_bus(asio::io_context& io, const std::string& uri,
                                           Side side) {
  auto link = open_frames(io.get_executor(), parse_uri(uri).value(), side);
  if (!link) ADD_FAILURE() << uri << ": " << link.error().message;
  return link ? std::move(*link) : nullptr;
}

/// A folder for one test. The destructor removes it.
class Folder {
 public:
  Folder() {
    std::string name = std::filesystem::temp_directory_path() / "drydock-test-XXXXXX";
    path_ = ::mkdtemp(name.data());
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  std::string file(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

}  // namespace drydock::link::testing
