#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/system/result.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace drydock::control {

/// Where a running bench of that rig hears the same user's other programs.
std::string control_path(std::string_view rig_name);

/// A unix-domain socket that only its owner may open (mode 0600): each connection brings one line
/// and takes one line away. It is gone with this object; one that a killed program left is
/// replaced.
class ControlSocket {
 public:
  static constexpr std::size_t longest_line = 65'536, longest_answer = 4u << 20;

  using Answer = std::function<std::string(std::string_view request)>;

  /// Fails with a sentence: another program answers there, or the folder is not ours alone.
  static boost::system::result<std::unique_ptr<ControlSocket>, std::string> open(
      const boost::asio::any_io_executor& executor, const std::string& path, Answer answer);
  ControlSocket(const ControlSocket&) = delete;
  ControlSocket& operator=(const ControlSocket&) = delete;
  ~ControlSocket();

 private:
  struct House;
  explicit ControlSocket(std::shared_ptr<House> house) : house_(std::move(house)) {}
  std::shared_ptr<House> house_;
};

/// The other end: asks one line and waits for the answer. Fails with the system's error when
/// nobody is there.
boost::system::result<std::string> ask(const std::string& path, const std::string& request);

/// As ask(), without holding up the coroutine's thread; a bench that says nothing for a second
/// counts as none.
boost::asio::awaitable<boost::system::result<std::string>> ask_soon(std::string path,
                                                                    std::string request);

}  // namespace drydock::control
