#pragma once

#include <map>

#include "tests/drivers/link/running.hpp"

/// An slcan adapter that follows a script: it keeps every byte that it gets, and answers each line
/// as the script says. The empty line is a line too.
namespace drydock::link::testing {

class ScriptedAdapter {
 public:
  using Script = std::map<std::string, std::string, std::less<>>;

  /// `answers` has the answer to a line without its CR, or to two lines in succession ("S6 L").
  /// Lines that it does not name get `otherwise`.
  ScriptedAdapter(asio::io_context& io, const std::string& uri, Script answers,
                  std::string otherwise = "\r")
      : line_(open(io, uri, Side::device)),
        answers_(std::move(answers)),
        otherwise_(std::move(otherwise)) {
    asio::co_spawn(io, serve(), [](const std::exception_ptr&) {});
  }

  const std::string& got() const { return got_; }  ///< all bytes so far
  void end() { line_->close(); }

 private:
  asio::awaitable<void> serve() {
    Buffer buffer(512);
    for (;;) {
      const auto received = co_await line_->read(buffer);
      if (!received) co_return;
      for (std::size_t i = 0; i < received->size; ++i) {
        const char c = static_cast<char>(buffer[i]);
        got_ += c;
        if (c != '\r') {
          text_ += c;
          continue;
        }
        const Buffer answer = bytes(answer_now());
        before_ = std::exchange(text_, {});
        if (!answer.empty()) (void)co_await line_->write(answer);
      }
    }
  }

  const std::string& answer_now() const {
    auto found = answers_.find(before_ + " " + text_);
    if (found == answers_.end()) found = answers_.find(text_);
    return found == answers_.end() ? otherwise_ : found->second;
  }

  std::unique_ptr<ByteLink> line_;
  Script answers_;
  std::string otherwise_, got_, text_, before_;
};

}  // namespace drydock::link::testing
