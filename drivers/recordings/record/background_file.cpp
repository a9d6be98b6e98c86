#include "drivers/recordings/record/background_file.hpp"

#include <utility>

namespace drydock::record {

BackgroundFile::BackgroundFile(FileSeries file)
    : file_(std::move(file)), empty_(most_waiting), progress_{file_.error(), file_.size()} {
  waiting_.reserve(most_waiting);
  thread_ = std::thread([this] { work(); });  // last: it reads all of the above
}

BackgroundFile::~BackgroundFile() {
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

bool BackgroundFile::take(mcap::Block& block) {
  if (progress_.error || empty_.empty()) {
    progress_.lost += block.messages();
    return false;
  }
  std::swap(block, empty_.back());
  waiting_.push_back(std::move(empty_.back()));
  empty_.pop_back();
  changed_.notify_all();
  return true;
}

bool BackgroundFile::put(mcap::Block& block) {
  const std::scoped_lock lock(mutex_);
  return take(block);
}

bool BackgroundFile::put_when_there_is_room(mcap::Block& block) {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return progress_.error || !empty_.empty(); });
  return take(block);
}

void BackgroundFile::work() {
  std::unique_lock lock(mutex_);
  for (;;) {
    changed_.wait(lock, [this] { return ended_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    mcap::Block block = std::move(waiting_.front());
    waiting_.erase(waiting_.begin());
    const auto lost = progress_.lost;
    lock.unlock();
    const auto error = file_.write(block, lost);
    lock.lock();
    (error ? progress_.lost : progress_.messages) += block.messages();
    note(error);
    block.clear();
    empty_.push_back(std::move(block));
    changed_.notify_all();
  }
}

void BackgroundFile::note(const boost::system::error_code& error) {
  progress_.error = error;
  if (error) progress_.failed_file = file_.path();
  progress_.size = file_.size();
  progress_.files = file_.files();
  progress_.deleted = file_.deleted();
}

boost::system::error_code BackgroundFile::finish() {
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
  }
  changed_.notify_all();
  thread_.join();
  note(file_.finish(progress_.lost));
  return progress_.error;
}

BackgroundFile::Progress BackgroundFile::progress() const {
  const std::scoped_lock lock(mutex_);
  return progress_;
}

}  // namespace drydock::record
