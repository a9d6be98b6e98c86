#pragma once

#include <boost/asio/io_context.hpp>
#include <memory>
#include <string>
#include <vector>

#include "drivers/recordings/record/recording.hpp"

namespace drydock::replay {

/// The sensors' side of a recording for other programs: what a link once received is written to a
/// pty, a CAN interface or another link when its time has come. What the programs send is read and
/// dropped, as the answers are in the recording.
class Onto {
 public:
  /// `wanted`: "NAME=URI" each, NAME of a link or of a device on it; "auto" opens every link, a
  /// serial one as pty:NAME, a bus as can:auto?name=NAME. Throws std::runtime_error with one line.
  Onto(boost::asio::io_context& io, const std::vector<record::RecordedLink>& links,
       const std::vector<std::string>& wanted);
  ~Onto();
  Onto(const Onto&) = delete;
  Onto& operator=(const Onto&) = delete;

  void send(const record::RawEvent& event);
  /// Closes the links; what waits on them ends as the io_context goes on.
  void close();

  std::vector<std::string> lines() const;  ///< for a person: what is where
  std::uint64_t lost() const;              ///< the other side did not take it in time, or an error

  class Line;  ///< one link

 private:
  void open(const record::RecordedLink& link, std::size_t index, const std::string& uri);

  boost::asio::io_context& io_;
  std::vector<std::shared_ptr<Line>> lines_;  ///< by link of the recording; empty: not wanted
};

}  // namespace drydock::replay
