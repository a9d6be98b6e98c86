#pragma once

#include <boost/system/result.hpp>
#include <map>
#include <string>
#include <type_traits>
#include <variant>

#include "drivers/recordings/mcap/reader.hpp"
#include "drivers/recordings/record/raw_message.hpp"
#include "drivers/recordings/record/recorder.hpp"

namespace drydock::record {

/// One line that says what is wrong with which file.
struct RecordingError {
  std::string line;
};
[[noreturn]] void throw_exception_from_error(const RecordingError& error,
                                             const boost::source_location& where);

/// Bytes or a frame as they went over a link, and which of `links()` that was.
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

/// What was understood: a ROS 2 message of `channel`.
struct Understood {
  const mcap::Channel* channel = nullptr;
  const mcap::Schema* schema = nullptr;
  Stamp at{};
  mcap::Bytes cdr;
};

using Event = std::variant<RawEvent, Understood>;

/// Reads a recording that Recorder wrote from front to back, a cut one up to the cut.
class Recording {
 public:
  /// What is not messages and is therefore kept may not come to more than this.
  static constexpr std::size_t most_kept = 256u << 20;

  static boost::system::result<Recording, RecordingError> open(const std::string& path);
  /// From a stream; `name` is for the error.
  static boost::system::result<Recording, RecordingError> open(std::unique_ptr<std::istream> file,
                                                               const std::string& name);

  /// Known from the start, as long as the file was not cut before its first message.
  const std::vector<RecordedLink>& links() const { return links_; }
  const std::vector<mcap::Attachment>& attachments() const { return attachments_; }
  const std::vector<mcap::Metadata>& metadata() const { return metadata_; }
  /// Text of an attachment; empty where there is none of that name.
  std::string attachment(std::string_view name) const;

  /// Which of links() a raw channel is of; empty: not one of them.
  std::optional<std::size_t> link_of(std::uint16_t channel) const;
  /// Topics of what was understood, as channels.
  std::vector<const mcap::Channel*> understood() const;
  /// Time of the first message; empty where there is none.
  std::optional<Stamp> begin() const { return begin_; }
  /// How much of the file has been read, 0 to 1.
  double done() const;

  /// Empty at the end. What the event points to holds until the next call.
  std::optional<Event> next();

  /// After the end: empty, or one line that says where the file is cut or damaged.
  const std::string& damage() const { return damage_.empty() ? reader_.damage() : damage_; }
  std::uint64_t unreadable() const { return unreadable_; }  ///< raw messages that are not ours

 private:
  explicit Recording(mcap::Reader reader) : reader_(std::move(reader)) {}
  void note(mcap::Record&& record);
  template <class Kept>
  void keep(Kept& place, std::type_identity_t<Kept>&& record);
  void note_channel(mcap::Channel&& channel);
  std::optional<Event> event_of(const mcap::Message& message);

  mcap::Reader reader_;
  std::vector<RecordedLink> links_;
  std::vector<mcap::Attachment> attachments_;
  std::vector<mcap::Metadata> metadata_;
  std::map<std::uint16_t, mcap::Schema> schemas_;
  std::map<std::uint16_t, mcap::Channel> channels_;
  std::map<std::uint16_t, std::size_t> link_of_;  ///< raw channels
  std::optional<mcap::Message> first_;
  std::optional<Stamp> begin_;
  std::uint64_t unreadable_ = 0;
  std::size_t kept_bytes_ = 0;
  std::string damage_;
};

}  // namespace drydock::record
