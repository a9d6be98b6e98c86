#include "hil/replay/onto.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <stdexcept>

#include "drivers/link/link.hpp"

namespace drydock::replay {

namespace asio = boost::asio;

/// Has two coroutines: one writes the queue, one reads. Both keep the line alive.
class Onto::Line : public std::enable_shared_from_this<Line> {
 public:
  explicit Line(asio::io_context& io, std::string shown)
      : shown_(std::move(shown)), wake_(io, asio::steady_timer::time_point::max()) {}
  virtual ~Line() = default;

  void start() {
    asio::co_spawn(wake_.get_executor(), write(), asio::detached);
    asio::co_spawn(wake_.get_executor(), listen(), asio::detached);
  }
  void stop() {
    stopped_ = true;
    wake_.cancel();
    close();
  }
  virtual void queue(const record::RawEvent& event) = 0;
  std::uint64_t lost() const { return lost_; }
  const std::string& shown() const { return shown_; }

 protected:
  /// A longer queue means that the reader no longer reads.
  static constexpr std::size_t longest_queue = 4096;

  virtual asio::awaitable<bool> write_next() = 0;  ///< false: the queue is empty
  virtual asio::awaitable<void> listen() = 0;
  virtual void close() = 0;

  template <class Queue, class Item>
  void push(Queue& queue, Item&& item) {
    if (queue.size() >= longest_queue) {
      ++lost_;
      return;
    }
    queue.push_back(std::forward<Item>(item));
    wake_.cancel();
  }
  void note(bool written) { lost_ += written ? 0 : 1; }
  bool stopped() const { return stopped_; }

 private:
  asio::awaitable<void> write() {
    const auto self = shared_from_this();
    while (!stopped_) {
      if (co_await write_next()) continue;
      boost::system::error_code woken;
      co_await wake_.async_wait(asio::redirect_error(asio::use_awaitable, woken));
    }
  }

  std::string shown_;
  asio::steady_timer wake_;
  std::uint64_t lost_ = 0;
  bool stopped_ = false;
};

namespace {

class OntoBytes final : public Onto::Line {
 public:
  OntoBytes(asio::io_context& io, std::string shown, std::unique_ptr<link::ByteLink> link)
      : Line(io, std::move(shown)), link_(std::move(link)) {}
  void queue(const record::RawEvent& event) override {
    const auto& read = std::get<record::RawBytes>(event.content);
    push(waiting_, std::vector<std::uint8_t>(read.data.begin(), read.data.end()));
  }

 private:
  asio::awaitable<bool> write_next() override {
    if (waiting_.empty()) co_return false;
    const auto bytes = std::move(waiting_.front());
    waiting_.pop_front();
    note((co_await link_->write(bytes)).has_value());
    co_return true;
  }
  asio::awaitable<void> listen() override {
    const auto self = shared_from_this();
    std::array<std::uint8_t, 256> dropped{};
    while (!stopped())
      if (!co_await link_->read(dropped)) co_return;
  }
  void close() override { link_->close(); }

  std::unique_ptr<link::ByteLink> link_;
  std::deque<std::vector<std::uint8_t>> waiting_;
};

class OntoFrames final : public Onto::Line {
 public:
  OntoFrames(asio::io_context& io, std::string shown, std::unique_ptr<link::FrameLink> link)
      : Line(io, std::move(shown)), link_(std::move(link)) {}
  void queue(const record::RawEvent& event) override {
    const auto& frame = std::get<record::RawFrame>(event.content).frame;
    if (!frame.error)
      push(waiting_, frame);  // the controller makes an error frame, no node sends it
  }

 private:
  asio::awaitable<bool> write_next() override {
    if (waiting_.empty()) co_return false;
    const auto frame = waiting_.front();
    waiting_.pop_front();
    note((co_await link_->write(frame)).has_value());
    co_return true;
  }
  asio::awaitable<void> listen() override {
    const auto self = shared_from_this();
    while (!stopped())
      if (!co_await link_->read()) co_return;
  }
  void close() override { link_->close(); }

  std::unique_ptr<link::FrameLink> link_;
  std::deque<wire::CanFrame> waiting_;
};

bool is_of(const record::RecordedLink& link, const std::string& name) {
  return link.name == name || std::ranges::find(link.devices, name) != link.devices.end();
}

std::string automatic_uri(const record::RecordedLink& link) {
  const auto was = link::parse_uri(link.uri);
  if (!link.frames) return "pty:" + link.name;
  return fmt::format("can:auto?name={}&bitrate={}", link.name.substr(0, 15),
                     was ? was->bitrate().value_or(250'000) : 250'000);
}

std::string shown_text(const record::RecordedLink& link, const link::Uri& uri) {
  std::string where = uri.text;
  if (uri.scheme == link::Scheme::pty) where = link::pty_path(uri.target);
  if (uri.scheme == link::Scheme::can_auto) where = link::can_auto_level(uri);
  return fmt::format("{} ({}): {}", link.name, fmt::join(link.devices, ", "), where);
}

template <class Opened>
auto opened(Opened result) {
  if (!result) throw std::runtime_error("--onto: " + result.error().message);
  return std::move(*result);
}

std::vector<std::string> names_of(const std::vector<record::RecordedLink>& links) {
  std::vector<std::string> names;
  names.reserve(links.size());
  for (const auto& link : links) names.push_back(link.name);
  return names;
}

}  // namespace

Onto::Onto(asio::io_context& io, const std::vector<record::RecordedLink>& links,
           const std::vector<std::string>& wanted)
    : io_(io), lines_(links.size()) {
  for (const auto& text : wanted) {
    const auto equals = text.find('=');
    const std::string name = text.substr(0, equals);
    bool known = false;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (text != "auto" && !is_of(links[i], name)) continue;
      known = true;
      open(links[i], i, text == "auto" ? automatic_uri(links[i]) : text.substr(equals + 1));
    }
    if (!known || (text != "auto" && equals == std::string::npos))
      throw std::runtime_error(fmt::format(
          "--onto {}: allowed: auto, or NAME=URI with a link or device of the recording: {}", text,
          fmt::join(names_of(links), ", ")));
  }
}

void Onto::open(const record::RecordedLink& link, std::size_t index, const std::string& text) {
  const auto uri = link::parse_uri(text);
  if (!uri) throw std::runtime_error("--onto: " + uri.error().message);
  const auto carries = link.frames ? link::Carries::frames : link::Carries::bytes;
  if (uri->recorded() || uri->carries() != carries)
    throw std::runtime_error(fmt::format("--onto {}={}: that is no {} of other programs", link.name,
                                         text, link.frames ? "CAN bus" : "byte link"));
  const auto side = link::Side::device;
  auto& line = lines_[index];
  if (line) throw std::runtime_error("--onto: " + link.name + " is given twice");
  if (link.frames) {
    auto bus = opened(link::open_frames(io_.get_executor(), *uri, side));
    line = std::make_shared<OntoFrames>(io_, shown_text(link, *uri), std::move(bus));
  } else {
    auto bytes = opened(link::open_bytes(io_.get_executor(), *uri, side));
    line = std::make_shared<OntoBytes>(io_, shown_text(link, *uri), std::move(bytes));
  }
  line->start();
}

void Onto::close() {
  for (const auto& line : lines_)
    if (line) line->stop();
}

Onto::~Onto() {
  close();
  io_.restart();
  io_.poll();
}

void Onto::send(const record::RawEvent& event) {
  if (event.direction() == record::Direction::received && lines_[event.link])
    lines_[event.link]->queue(event);
}

std::vector<std::string> Onto::lines() const {
  std::vector<std::string> all;
  for (const auto& line : lines_)
    if (line) all.push_back(line->shown());
  return all;
}

std::uint64_t Onto::lost() const {
  std::uint64_t all = 0;
  for (const auto& line : lines_) all += line ? line->lost() : 0;
  return all;
}

}  // namespace drydock::replay
