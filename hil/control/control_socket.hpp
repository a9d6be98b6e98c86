#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/system/result.hpp>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace drydock::control {

/// The socket on which a running bench of that rig takes orders from the same user's programs:
/// `RIGNAME.control`. A path has room for 107 characters; a longer name is replaced by its hash.
std::string control_path(std::string_view rig_name);

/// A unix-domain socket that only its owner may open (mode 0600). Each connection sends one line
/// and gets one line. The destructor removes the socket; a socket that a killed program left is
/// replaced.
class ControlSocket {
 public:
  static constexpr std::size_t longest_line = 65'536, longest_answer = 4u << 20;

  using Answer = std::function<std::string(std::string_view request)>;

  /// Fails with a sentence if another program answers there, or if other users may write to the
  /// folder.
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

/// The client side: sends one line and waits for the answer. Fails with the system's error when no
/// bench answers.
boost::system::result<std::string> ask(const std::string& path, const std::string& request);

/// As ask(), but does not block the coroutine's thread. A bench that does not answer within one
/// second counts as absent.
boost::asio::awaitable<boost::system::result<std::string>> ask_soon(std::string path,
                                                                    std::string request);

}  // namespace drydock::control
