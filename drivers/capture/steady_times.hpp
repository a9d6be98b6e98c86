#pragma once

#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

namespace drydock::capture {

/// The times of a recording whose computer's clock was set back while it ran: they go on from the
/// last one before. Feed all records of a file in their order.
class SteadyTimes {
 public:
  /// `stream`: the interface or line of the record. Records of one stream stand in the order in
  /// which they came; those of two may change places by what a computer holds them.
  std::chrono::nanoseconds of(std::string_view stream, std::chrono::nanoseconds written);

  /// Of a record that stands beside the streams and tells no order: on that side of the last step
  /// where it is nearer to the latest time.
  std::chrono::nanoseconds beside(std::chrono::nanoseconds written) const;

  std::uint64_t steps() const { return steps_; }  ///< how often the clock was set back
  /// Records whose time is written before that of an earlier one, and by how much at most.
  std::uint64_t behind() const { return behind_; }
  std::chrono::nanoseconds most_behind() const { return most_behind_; }
  /// "the recording's clock was set back once, by 3600.000 s: ..."; empty: it was not.
  std::string in_words() const;

 private:
  bool went_back(std::string_view stream, std::chrono::nanoseconds written);

  std::map<std::string, std::chrono::nanoseconds, std::less<>> last_;  ///< as written
  std::chrono::nanoseconds latest_{}, moved_{0};  ///< of all streams; and what is added now
  std::chrono::nanoseconds latest_written_{}, most_behind_{0}, most_{0};
  std::uint64_t steps_ = 0, behind_ = 0;
  bool begun_ = false;
};

}  // namespace drydock::capture
