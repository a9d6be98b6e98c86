#pragma once

#include <boost/system/result.hpp>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <variant>

#include "drivers/capture/steady_times.hpp"
#include "drivers/recordings/mcap/reader.hpp"
#include "drivers/recordings/record/raw_message.hpp"
#include "drivers/recordings/record/recorder.hpp"

namespace drydock::record {

/// One line that names the file and the problem.
struct RecordingError {
  std::string line;
};
[[noreturn]] void throw_exception_from_error(const RecordingError& error,
                                             const boost::source_location& where);

/// Bytes or a frame on a link. `link` is the index in `links()`.
struct RawEvent {
  std::size_t link = 0;
  std::variant<RawBytes, RawFrame> content;

  Stamp at() const {
    return std::visit([](const auto& raw) { return raw.at; }, content);
  }
  Direction direction() const {
    return std::visit([](const auto& raw) { return raw.direction; }, content);
  }
};

/// A decoded ROS 2 message of `channel`.
struct Understood {
  const mcap::Channel* channel = nullptr;
  const mcap::Schema* schema = nullptr;
  Stamp at{};
  mcap::Bytes cdr;
};

using Event = std::variant<RawEvent, Understood>;

/// Reads a recording of Recorder from start to end. It reads a truncated recording up to its end.
/// Where the links' times jump back, because the host's clock was set, times go on from the last
/// one before.
class Recording {
 public:
  /// Limit of the memory for records that are kept; messages are not kept.
  static constexpr std::size_t most_kept = 256u << 20;

  static boost::system::result<Recording, RecordingError> open(const std::string& path);
  /// Reads from a stream. Errors show `name`.
  static boost::system::result<Recording, RecordingError> open(std::unique_ptr<std::istream> file,
                                                               const std::string& name);

  /// All that stand before the first message or in the summary. Others are not read.
  const std::vector<RecordedLink>& links() const { return links_; }
  const std::vector<mcap::Attachment>& attachments() const { return attachments_; }
  const std::vector<mcap::Metadata>& metadata() const { return metadata_; }
  /// Text of an attachment. Empty if there is none of that name.
  std::string attachment(std::string_view name) const;

  /// The index in links() for a raw channel. Empty if it belongs to no link.
  std::optional<std::size_t> link_of(std::uint16_t channel) const;
  /// The channels of decoded messages.
  std::vector<const mcap::Channel*> understood() const;
  /// Time of the first message. Empty if there is none.
  std::optional<Stamp> begin() const { return begin_; }
  /// The share of the file that has been read, 0 to 1.
  double done() const;

  /// Empty at the end. The event's pointers and views are valid until the next call.
  std::optional<Event> next();

  /// Use it after the end. Empty, or one line that says where the file is truncated or damaged.
  const std::string& damage() const { return damage_.empty() ? reader_.damage() : damage_; }
  /// How the times of what was read so far were changed: as capture::SteadyTimes::in_words(), and
  /// how many are later than any clock's; and links that begin too late. Empty: there is nothing
  /// to tell.
  std::string clock_note() const;
  std::uint64_t unreadable() const { return unreadable_; }  ///< raw, not decoded

 private:
  explicit Recording(mcap::Reader reader) : reader_(std::move(reader)) {}
  void note(mcap::Record&& record);
  template <class Kept>
  void keep(Kept& place, std::type_identity_t<Kept>&& record);
  void note_channel(mcap::Channel&& channel);
  std::optional<Event> event_of(const mcap::Message& message);
  void go_on(Event& event);

  mcap::Reader reader_;
  std::vector<RecordedLink> links_;
  std::set<std::uint16_t> late_links_;  ///< channels of links that nobody knew at the beginning
  bool is_open_ = false;
  std::vector<mcap::Attachment> attachments_;
  std::vector<mcap::Metadata> metadata_;
  std::map<std::uint16_t, mcap::Schema> schemas_;
  std::map<std::uint16_t, mcap::Channel> channels_;
  std::map<std::uint16_t, std::size_t> link_of_;  ///< by raw channel
  std::optional<mcap::Message> first_;
  std::optional<Stamp> begin_;
  capture::SteadyTimes times_;
  std::uint64_t unreadable_ = 0;
  std::uint64_t beyond_ = 0;  ///< messages after mcap::latest_time
  std::size_t kept_bytes_ = 0;
  std::string damage_;
};

}  // namespace drydock::record
