#include "hil/replay/onto.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <stdexcept>

#include "drivers/link/pump.hpp"
#include "drivers/link/reading.hpp"

namespace drydock::replay {

namespace asio = boost::asio;

/// One link that is played to other programs.
class Onto::Line {
 public:
  explicit Line(std::string shown) : shown_(std::move(shown)) {}
  virtual ~Line() = default;
  virtual void start() = 0;
  virtual void stop() = 0;
  virtual void queue(const record::RawEvent& event) = 0;
  std::uint64_t lost() const { return lost_; }
  const std::string& shown() const { return shown_; }

 protected:
  void note(bool written) { lost_ += written ? 0 : 1; }

 private:
  std::string shown_;
  std::uint64_t lost_ = 0;
};

namespace {

/// A longer queue means that the reader no longer reads.
constexpr std::size_t longest_queue = 4096;

/// Has two coroutines: one writes the queue, one reads. Both keep the line alive.
template <class Link, class Queue>
class OntoLink final : public Onto::Line,
                       public std::enable_shared_from_this<OntoLink<Link, Queue>> {
 public:
  OntoLink(asio::io_context& io, std::string shown, std::unique_ptr<Link> link)
      : Line(std::move(shown)),
        link_(std::move(link)),
        pump_(io.get_executor(), *link_, longest_queue,
              [this](const Item&, const boost::system::error_code& failure) {
                note(!failure);
                return pump_.is_open();
              }),
        executor_(io.get_executor()) {}

  void start() override {
    const auto ended = [self = this->shared_from_this()](const auto&...) {};
    asio::co_spawn(executor_, pump_.drain_until_closed(), ended);
    asio::co_spawn(executor_, link::read_until_lost<Link>(*link_, drop), ended);
  }
  void stop() override { pump_.close(); }
  void queue(const record::RawEvent& event) override {
    if constexpr (std::is_same_v<Link, link::ByteLink>) {
      note(pump_.put(std::get<record::RawBytes>(event.content).data));
    } else {
      const auto& frame = std::get<record::RawFrame>(event.content).frame;
      if (!frame.error) note(pump_.put(frame));  // the controller makes an error frame, no node
    }
  }

 private:
  using Item = typename link::Traffic<Link>::Item;
  static void drop(const Item&, link::Stamp) {}

  std::unique_ptr<Link> link_;
  link::Pump<Link, Queue> pump_;
  asio::any_io_executor executor_;
};

using OntoBytes = OntoLink<link::ByteLink, link::MessageQueue>;
using OntoFrames = OntoLink<link::FrameLink, link::Traffic<link::FrameLink>::Queue>;

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
