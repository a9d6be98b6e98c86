#include "hil/campaign/runs/local_engine.hpp"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "hil/campaign/runs/one_run.hpp"
#include "hil/campaign/runs/scratch_folder.hpp"

namespace drydock::campaign {
namespace {

class LocalEngine {
 public:
  LocalEngine(const CampaignConfig& campaign, std::span<const std::size_t> indexes,
              Journal& journal, study::Progress& progress)
      : campaign_(campaign), indexes_(indexes), journal_(journal), progress_(progress) {}

  std::size_t run(unsigned jobs) {
    {
      std::vector<std::jthread> others;
      for (unsigned i = 1; i < jobs && i < indexes_.size(); ++i)
        others.emplace_back([this] { work(); });
      work();
    }
    if (failure_) std::rethrow_exception(failure_);
    return done_;
  }

 private:
  bool stopped() const { return failed_ || progress_.stopped(); }

  void work() {
    try {
      for (std::size_t k = next_++; k < indexes_.size() && !stopped(); k = next_++)
        one(indexes_[k]);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      failed_ = true;
    }
  }

  void one(std::size_t index) {
    const ScratchFolder folder;
    const auto record = do_run(campaign_, index, folder.path(), [this] { return stopped(); });
    if (!record) return;
    journal_.add(*record);
    const std::lock_guard lock(mutex_);
    progress_.on_run(campaign_.name, ++done_, indexes_.size());
  }

  const CampaignConfig& campaign_;
  std::span<const std::size_t> indexes_;
  Journal& journal_;
  study::Progress& progress_;
  std::atomic<std::size_t> next_ = 0;
  std::atomic<bool> failed_ = false;
  std::mutex mutex_;  // protects what follows
  std::size_t done_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::size_t run_here(const CampaignConfig& campaign, std::span<const std::size_t> indexes,
                     unsigned jobs, Journal& journal, study::Progress& progress) {
  return LocalEngine(campaign, indexes, journal, progress).run(jobs);
}

}  // namespace drydock::campaign
