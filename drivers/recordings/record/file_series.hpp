#pragma once

#include <deque>
#include <optional>

#include "drivers/recordings/record/split.hpp"

namespace drydock::record {

/// What every file of a recording begins with.
struct Beginning {
  mcap::Header header;
  std::vector<mcap::Attachment> attachments{};
  std::vector<mcap::Metadata> metadata{};
};

/// Writes a recording into one file, or into one after another. Each is complete: it has the
/// beginning, the schemas and channels, and its own summary. A divided recording may forget: the
/// oldest of its own files are deleted.
class FileSeries {
 public:
  FileSeries(Parts parts, Beginning beginning);

  /// `lost`: messages that were not recorded so far.
  boost::system::error_code write(const mcap::Block& block, std::uint64_t lost);
  boost::system::error_code finish(std::uint64_t lost);

  boost::system::error_code error() const { return error_ ? error_ : file_->error(); }
  std::uint64_t size() const { return finished_size_ + file_->size(); }  ///< of all files, in bytes
  const std::string& path() const { return part_.path; }                 ///< of the present file
  std::uint64_t files() const { return files_; }
  std::uint64_t deleted() const { return deleted_; }  ///< of the files

 private:
  using Time = std::chrono::nanoseconds;
  struct Finished {
    std::string path;
    std::uint64_t device, inode, size;
    Time ended;
  };

  void begin(Part part);
  boost::system::error_code change(std::uint64_t lost);
  boost::system::error_code finish_file(std::uint64_t lost);
  bool is_over(const mcap::Block& block) const;
  void remember(const mcap::Block& block);
  Time now(const mcap::Block& block) const;
  void forget();
  bool is_too_much() const;

  Split split_;
  NextPart next_;
  Beginning beginning_;
  mcap::Block channels_;  ///< schemas and channels so far, for the next file
  std::optional<mcap::FileWriter> file_;
  Part part_;
  boost::system::error_code error_;  ///< no next file could be made
  Time now_{0};
  std::optional<Time> begun_;  ///< when the file got its first message
  std::uint64_t files_ = 0, deleted_ = 0, finished_size_ = 0, kept_size_ = 0, told_lost_ = 0;
  std::deque<Finished> kept_;  ///< oldest first; without the present file
};

}  // namespace drydock::record
