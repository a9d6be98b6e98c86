#include "drivers/link/can/slcan.hpp"

#include <algorithm>
#include <array>
#include <boost/asio/error.hpp>
#include <boost/asio/experimental/awaitable_operators.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/circular_buffer.hpp>
#include <utility>
#include <variant>

#include "drivers/io/signal.hpp"
#include "drivers/link/can/own_frames.hpp"
#include "drivers/link/can/slcan_damage.hpp"
#include "drivers/link/can/slcan_port.hpp"
#include "drivers/link/can/slcan_rate.hpp"
#include "drivers/link/can/slcan_trouble.hpp"
#include "drivers/wire/can/slcan.hpp"
#include "drivers/wire/can/slcan_report.hpp"
#include "drivers/wire/text_bytes.hpp"

namespace drydock::link {
namespace {

namespace slcan = wire::slcan;
using namespace std::chrono_literals;

constexpr std::size_t read_size = 512;
constexpr std::size_t most_frames_per_read = 128;  // the shortest line has 4 bytes

/// An adapter answers a command within milliseconds; one behind a radio or a network needs more,
/// and so does a busy host. One that has not answered anything yet may be one that never does.
constexpr auto first_answer_patience = 500ms, answer_patience = 2000ms;
/// Some adapters answer the empty line as well as C: nothing more comes after this silence.
constexpr auto quiet_after = 50ms;

/// An adapter that was reset, or that another program closed, says nothing, as a silent bus does.
/// After this silence its channel is opened again, then less and less often; and where it refuses a
/// frame it is asked sooner.
constexpr auto first_silence = 2000ms, longest_silence = 30000ms, silence_of_refusal = 500ms;

/// The empty line ends whatever an earlier program, or a write of ours, left incomplete.
constexpr std::string_view closing = "\rC\r";

class SlcanLink final : public FrameLink {
 public:
  SlcanLink(const asio::any_io_executor& executor, std::unique_ptr<ByteLink> line,
            SlcanChannel channel)
      : line_(std::move(line)),
        rate_(channel),
        open_(channel.listens ? "L" : "O"),
        patience_(executor),
        changed_(std::make_shared<io::Signal>(executor)),
        frames_(most_frames_per_read),
        written_(most_frames_per_read) {}

  Task<ReceivedFrame> read() override;
  Task<void> write(const wire::CanFrame& frame) override;
  void close() override {
    if (std::exchange(spoken_, false)) line_->say_last(wire::bytes_of(closing));
    line_->close();
    changed_->notify();
  }
  Provenance provenance() const override { return line_->provenance(); }
  std::uint64_t dropped() const override { return dropped_; }
  std::optional<unsigned> bit_rate() const override { return rate_.found(); }
  std::string_view note() const override {
    if (!rate_.note().empty() && damage_.note().empty()) return rate_.note();
    if (channel_ == Channel::open && silent_)
      return "the slcan adapter answers no command: whether its channel is open, only its frames "
             "show";
    return damage_.note();
  }

 private:
  enum class Channel : std::uint8_t { closed, opening, open };

  using Answer = slcan::Answer;

  Task<void> opened();
  Task<void> open_channel();
  /// One read, or what silence asks for.
  Task<void> take_or_open_again();
  Task<void> close_first();
  Task<void> command(std::string_view text);
  /// Reads until there is an answer or the limit is over. With `frames_too` a frame ends it as
  /// well.
  Task<void> hear_for(std::chrono::steady_clock::duration limit, bool frames_too = false);
  Task<void> take();
  void take_in(wire::Bytes bytes, Stamp at);
  void hear(Answer answer);
  void hear(const slcan::Command& said);
  void keep(const wire::CanFrame& frame, Stamp at);

  std::unique_ptr<ByteLink> line_;
  SlcanRate rate_;
  std::string_view open_;     ///< the command that opens this channel: O, L
  bool at_our_rate_ = false;  ///< frames from now on are those of the present channel
  asio::steady_timer patience_;
  std::optional<Answer> answer_;  ///< the first one since it was emptied
  bool silent_ = true;            ///< no answer so far
  bool spoken_ = false;           ///< the adapter has got a command
  bool refused_ = false;          ///< a frame of ours, since the channel was opened
  unsigned writing_ = 0;          ///< frames that are on their way to the adapter
  std::chrono::steady_clock::time_point heard_at_{};  ///< a frame, or the channel was opened
  std::chrono::steady_clock::duration silence_ = first_silence;
  std::shared_ptr<io::Signal> changed_;  ///< signalled when the channel is no longer opening
  Channel channel_ = Channel::closed;
  wire::Framer<wire::Slcan::max_frame> framer_;
  std::array<std::uint8_t, read_size> buffer_{};
  boost::circular_buffer<ReceivedFrame> frames_;
  std::uint64_t dropped_ = 0;
  bool echoes_ = false;  ///< the adapter repeats what it is told
  OwnFrames written_;    ///< whose echoes may still come
  SlcanDamage damage_;
};

/// A read and a write may both be first: one opens the channel and the other waits, so that their
/// lines never mix.
Task<void> SlcanLink::opened() {
  while (channel_ == Channel::opening) co_await changed_->wait();
  if (channel_ == Channel::open) co_return boost::system::result<void>{};
  channel_ = Channel::opening;
  const auto outcome = co_await open_channel();
  channel_ = outcome ? Channel::open : Channel::closed;
  refused_ = false;
  heard_at_ = std::chrono::steady_clock::now();
  changed_->notify();
  co_return outcome;
}

Task<void> SlcanLink::open_channel() {
  at_our_rate_ = false;
  if (const auto closed = co_await close_first(); !closed) co_return closed;
  rate_.choose();
  auto done = co_await command(rate_.command());
  for (std::size_t others = slcan_search_order.size() - 1;
       rate_.is_sought() && !done && is_refused_rate(done.error()) && others > 0; --others) {
    rate_.try_next();
    done = co_await command(rate_.command());
  }
  if (!done) co_return done;
  at_our_rate_ = true;
  co_return co_await command(open_);
}

/// A channel that is closed refuses C, and an adapter may answer the empty line or not: all that
/// counts is that it answers.
Task<void> SlcanLink::close_first() {
  spoken_ = true;
  silent_ = true;
  answer_.reset();
  if (const auto written = co_await line_->write(wire::bytes_of(closing)); !written)
    co_return written;
  if (const auto heard = co_await hear_for(first_answer_patience); !heard) co_return heard;
  while (answer_) {
    answer_.reset();
    if (const auto heard = co_await hear_for(quiet_after); !heard) co_return heard;
  }
  frames_.clear();  // they belong to the channel that was open before, perhaps at another rate
  co_return boost::system::result<void>{};
}

/// Writes the command and heeds its answer. An adapter that has answered nothing at all so far may
/// be one that never does; frames show as well as an answer that the channel is open.
Task<void> SlcanLink::command(std::string_view text) {
  answer_.reset();
  const std::string line = std::string(text) + "\r";
  if (const auto written = co_await line_->write(wire::bytes_of(line)); !written) co_return written;
  const auto limit = silent_ ? first_answer_patience : answer_patience;
  if (const auto heard = co_await hear_for(limit, true); !heard) co_return heard;
  if (answer_ == Answer::refused) co_return slcan_refused(text);
  if (!answer_ && !silent_ && frames_.empty()) co_return slcan_unanswered(text);
  co_return boost::system::result<void>{};
}

Task<void> SlcanLink::hear_for(std::chrono::steady_clock::duration limit, bool frames_too) {
  using namespace asio::experimental::awaitable_operators;
  patience_.expires_after(limit);
  while (!answer_ && (!frames_too || frames_.empty())) {
    const auto first = co_await (take() || patience_.async_wait(as_outcome));
    if (first.index() == 1) break;
    if (const auto& taken = std::get<0>(first); !taken) co_return taken;
  }
  co_return boost::system::result<void>{};
}

/// One read, whose content is never lost, also if the patience ends in the same moment.
Task<void> SlcanLink::take() {
  const auto received = co_await line_->read(buffer_);
  if (!received) co_return received.error();
  take_in({buffer_.data(), received->size}, received->at);
  co_return boost::system::result<void>{};
}

Task<ReceivedFrame> SlcanLink::read() {
  if (const auto ready = co_await opened(); !ready) co_return ready.error();
  while (frames_.empty())
    if (const auto taken = co_await take_or_open_again(); !taken) co_return taken.error();
  const ReceivedFrame frame = frames_.front();
  frames_.pop_front();
  co_return frame;
}

Task<void> SlcanLink::take_or_open_again() {
  using namespace asio::experimental::awaitable_operators;
  patience_.expires_at(heard_at_ + (refused_ ? silence_of_refusal : silence_));
  const auto first = co_await (take() || patience_.async_wait(as_outcome));
  if (first.index() == 0) co_return std::get<0>(first);
  if (writing_ > 0) {  // our lines must not mix
    heard_at_ = std::chrono::steady_clock::now();
    co_return boost::system::result<void>{};
  }
  if (rate_.is_sought())
    rate_.try_next();
  else
    silence_ = std::min<std::chrono::steady_clock::duration>(2 * silence_, longest_silence);
  channel_ = Channel::closed;
  co_return co_await opened();
}

void SlcanLink::take_in(wire::Bytes bytes, Stamp at) {
  framer_.feed(bytes, wire::Slcan::scan, [&](wire::Bytes line, std::size_t) {
    const auto message = wire::Slcan::decode(line);
    if (!message) return;
    if (const auto* frame = std::get_if<slcan::Frame>(&*message)) keep(frame->frame, at);
    if (const auto* said = std::get_if<slcan::Command>(&*message)) {
      hear(*said);
      if (const auto error = slcan::error_frame_of(said->text)) keep(*error, at);
    }
    if (const auto* reply = std::get_if<slcan::Reply>(&*message)) hear(reply->answer);
  });
  damage_.count(framer_.counters().bad_checksums, channel_ == Channel::open);
}

/// Only an echo has the form of our own commands. Then our frames come back as well, and must not
/// be taken for those of another node.
void SlcanLink::hear(const slcan::Command& said) {
  if (said.text == "C" || said.text == rate_.command() || said.text == open_) echoes_ = true;
}

void SlcanLink::hear(Answer answer) {
  refused_ = refused_ || (channel_ == Channel::open && answer == Answer::refused);
  const bool of_command = answer == Answer::done || answer == Answer::refused;
  if (!of_command || channel_ != Channel::opening) return;
  silent_ = false;
  if (!answer_) answer_ = answer;
}

void SlcanLink::keep(const wire::CanFrame& frame, Stamp at) {
  if (echoes_ && written_.take_echo(frame)) return;
  if (rate_.is_sought()) {
    if (frame.error || !at_our_rate_) return;  // a wrong rate gives nothing but error frames
    rate_.is_that_of_the_bus();
  }
  heard_at_ = std::chrono::steady_clock::now();
  silence_ = first_silence;
  refused_ = false;
  if (frames_.full())
    ++dropped_;
  else
    frames_.push_back({frame, at, false});
}

Task<void> SlcanLink::write(const wire::CanFrame& frame) {
  std::array<std::uint8_t, wire::Slcan::max_frame> line;
  const std::size_t size = slcan::encode(slcan::Frame{frame, std::nullopt}, line);
  if (size == 0) co_return ErrorCode(asio::error::operation_not_supported);
  if (const auto ready = co_await opened(); !ready) co_return ready.error();
  if (echoes_) written_.add(frame);
  ++writing_;
  const auto written = co_await line_->write({line.data(), size});
  --writing_;
  co_return written;
}

}  // namespace

std::unique_ptr<FrameLink> make_slcan(const asio::any_io_executor& executor,
                                      std::unique_ptr<ByteLink> line, SlcanChannel channel) {
  return std::make_unique<SlcanLink>(executor, std::move(line), channel);
}

OpenedFrames open_slcan(const asio::any_io_executor& executor, const Uri& uri, Side side) {
  auto line = open_bytes(executor, line_under(uri), side);
  if (!line) return line.error();
  if (side == Side::driver)
    return make_slcan(executor, std::move(*line),
                      {*uri.bitrate(), uri.only_listens(), uri.searches_bit_rate()});
  std::vector<std::unique_ptr<ByteLink>> lines;
  lines.push_back(std::move(*line));
  return SlcanBus::open(executor, std::move(lines))->join();
}

}  // namespace drydock::link
