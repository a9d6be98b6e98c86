#include "tests/hil/gpsd/gpsd.hpp"

#include <unistd.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/streambuf.hpp>
#include <boost/asio/write.hpp>
#include <cstdlib>
#include <istream>

#include "drivers/link/link.hpp"
#include "drivers/link/opening.hpp"
#include "tests/vcan/process.hpp"

namespace drydock::peer {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using link::as_outcome;
using namespace std::chrono_literals;

constexpr auto at_most = 30s;

/// A port on the loopback interface that is free now.
unsigned short free_port(asio::io_context& io) {
  return tcp::acceptor(io, {asio::ip::address_v4::loopback(), 0}).local_endpoint().port();
}

/// gpsd opens the pty at once (-n) while it is root, and drops its rights after that. `timeout`
/// ends it even if this test is killed.
std::vector<std::string> command(unsigned short port, const std::string& pty) {
  return {"timeout", "100", "gpsd", "-N", "-n", "-S", std::to_string(port), pty};
}

class Session {
 public:
  Session(const std::vector<std::uint8_t>& stream,
          const std::function<bool(const Reports&)>& enough)
      : stream_(stream),
        enough_(enough),
        line_(link::open_bytes(io_.get_executor(), link::parse_uri("pty:" + pty_).value(),
                               link::Side::device)
                  .value()),
        port_(free_port(io_)),
        gpsd_(command(port_, pty_)) {
    asio::co_spawn(io_, run(), asio::detached);
    asio::co_spawn(io_, drain(), asio::detached);
    limit_.async_wait([this](const auto& error) {
      if (!error) stop();
    });
  }

  Reports reports() {
    io_.run();
    return std::move(reports_);
  }

 private:
  asio::awaitable<void> run() {
    if (!co_await connect()) co_return stop();
    const std::string watch = "?WATCH={\"enable\":true,\"json\":true};\n";
    co_await asio::async_write(socket_, asio::buffer(watch), as_outcome);
    bool fed = false;
    while (!enough_(reports_)) {
      const auto [error, size] = co_await asio::async_read_until(socket_, text_, '\n', as_outcome);
      if (error) break;
      std::istream lines(&text_);
      std::string line;
      std::getline(lines, line);
      reports_.push_back(nlohmann::json::parse(line));
      if (!fed && reports_.back()["class"] == "WATCH") {  // the device is open now
        fed = true;
        if (!co_await line_->write(stream_)) break;
      }
    }
    stop();
  }

  asio::awaitable<bool> connect() {
    asio::steady_timer again(io_);
    while (!stopped_) {
      const auto [refused] =
          co_await socket_.async_connect({asio::ip::address_v4::loopback(), port_}, as_outcome);
      if (!refused) co_return true;
      socket_.close();
      again.expires_after(10ms);
      co_await again.async_wait(as_outcome);
    }
    co_return false;
  }

  /// Reads what gpsd sends to the receiver: probes and settings, which an emulated receiver
  /// ignores.
  asio::awaitable<void> drain() {
    std::array<std::uint8_t, 256> said;
    while (co_await line_->read(said)) continue;
  }

  void stop() {
    stopped_ = true;
    limit_.cancel();
    line_->close();
    socket_.close();
  }

  const std::vector<std::uint8_t>& stream_;
  const std::function<bool(const Reports&)>& enough_;
  const std::string pty_ = "/tmp/drydock-gpsd-" + std::to_string(::getpid());
  asio::io_context io_;
  std::unique_ptr<link::ByteLink> line_;
  unsigned short port_;
  vcan::Process gpsd_;
  tcp::socket socket_{io_};
  asio::steady_timer limit_{io_, at_most};
  asio::streambuf text_;
  bool stopped_ = false;
  Reports reports_;
};

}  // namespace

bool gpsd_is_installed() { return std::system("command -v gpsd >/dev/null") == 0; }

Reports reports_of_gpsd(const std::vector<std::uint8_t>& stream,
                        const std::function<bool(const Reports&)>& enough) {
  return Session(stream, enough).reports();
}

Reports of_class(const Reports& reports, std::string_view report_class) {
  Reports found;
  for (const auto& report : reports) {
    if (report.value("class", "") == report_class) found.push_back(report);
  }
  return found;
}

}  // namespace drydock::peer
