#include "drivers/recordings/record/file_series.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <utility>

namespace drydock::record {

using boost::system::error_code;

FileSeries::FileSeries(Parts parts, Beginning beginning)
    : split_(parts.split), next_(std::move(parts.next)), beginning_(std::move(beginning)) {
  begin(std::move(parts.first));
}

void FileSeries::begin(Part part) {
  part_ = std::move(part);
  file_.emplace(std::move(part_.sink), beginning_.header);
  for (const auto& attachment : beginning_.attachments) file_->write(attachment);
  for (const auto& entry : beginning_.metadata) file_->write(entry);
  file_->write(channels_);
  begun_.reset();
  ++files_;
}

FileSeries::Time FileSeries::now(const mcap::Block& block) const {
  if (split_.virtual_time) return Time{block.last_time()};
  return std::chrono::steady_clock::now().time_since_epoch();
}

/// The content of the block is larger than what becomes of it, so a file stays within its size.
bool FileSeries::is_over(const mcap::Block& block) const {
  if (!begun_ || block.messages() == 0) return false;
  return (split_.size > 0 && file_->size() + block.records().size() > split_.size) ||
         (split_.every.count() > 0 && now_ - *begun_ >= split_.every);
}

void FileSeries::remember(const mcap::Block& block) {
  for (const auto& schema : block.schemas()) channels_.add(schema);
  for (const auto& channel : block.channels()) channels_.add(channel);
}

error_code FileSeries::write(const mcap::Block& block, std::uint64_t lost) {
  now_ = now(block);
  if (is_over(block))
    if (const auto failed = change(lost)) return failed;
  remember(block);
  if (block.messages() > 0 && !begun_) begun_ = now_;
  const auto failed = file_->write(block);
  forget();
  return failed;
}

error_code FileSeries::change(std::uint64_t lost) {
  if (const auto failed = finish_file(lost)) return failed;
  const auto size = file_->size();
  auto next = next_();
  if (!next) return error_ = next.error();
  kept_.push_back({part_.path, part_.device, part_.inode, size, now_});
  kept_size_ += size;
  finished_size_ += size;
  begin(std::move(*next));
  return file_->error();
}

/// A file says how many messages were lost since the one before it, so the sum is that of the
/// recording.
error_code FileSeries::finish_file(std::uint64_t lost) {
  const auto since = lost - std::exchange(told_lost_, lost);
  file_->write(mcap::Metadata{"recording", {{"messages_lost", std::to_string(since)}}});
  return file_->finish();
}

error_code FileSeries::finish(std::uint64_t lost) {
  if (error()) return error();
  return finish_file(lost);
}

bool FileSeries::is_too_much() const {
  return (split_.keep_size > 0 && kept_size_ + file_->size() > split_.keep_size) ||
         (split_.keep_for.count() > 0 && now_ - kept_.front().ended > split_.keep_for);
}

/// A file that somebody has put in the place of ours stays.
void FileSeries::forget() {
  for (; !kept_.empty() && is_too_much(); kept_.pop_front()) {
    const auto& oldest = kept_.front();
    kept_size_ -= oldest.size;
    struct stat status {};
    const bool ours = ::lstat(oldest.path.c_str(), &status) == 0 &&
                      status.st_dev == oldest.device && status.st_ino == oldest.inode;
    if (ours && ::unlink(oldest.path.c_str()) == 0) ++deleted_;
  }
}

}  // namespace drydock::record
