#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"

namespace drydock::replay {

/// Plays the sensors' side of a recording to other programs. What a link once received is written
/// to a pty, a CAN interface or another link at its time. What the programs send is read and
/// dropped, because the answers are in the recording.
class Onto {
 public:
  /// Each `wanted` is "NAME=URI"; NAME is a link or a device on it. "auto" opens every link: a
  /// serial link as pty:NAME, a bus as can:auto?name=NAME. Throws std::runtime_error with one line.
  Onto(boost::asio::io_context& io, const std::vector<record::RecordedLink>& links,
       const std::vector<std::string>& wanted);
  ~Onto();
  Onto(const Onto&) = delete;
  Onto& operator=(const Onto&) = delete;

  void send(const record::RawEvent& event);
  /// Closes the links. Pending operations end when the io_context runs.
  void close();

  std::vector<std::string> lines() const;  ///< for a person: where each link is
  std::uint64_t lost() const;              ///< messages lost: the reader was too slow, or an error

  class Line;  ///< one link

 private:
  void open(const record::RecordedLink& link, std::size_t index, const std::string& uri);

  boost::asio::io_context& io_;
  std::vector<std::shared_ptr<Line>> lines_;  ///< by link of the recording; null: not wanted
};

}  // namespace drydock::replay
