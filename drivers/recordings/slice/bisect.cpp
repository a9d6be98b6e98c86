#include "drivers/recordings/slice/bisect.hpp"

#include <algorithm>

namespace drydock::slice {

namespace {

using record::Selection;
using record::Stamp;

/// A test that was interrupted counts as "does not fail", and no other test follows.
class Search {
 public:
  Search(const std::vector<Stamp>& times, const std::vector<std::string>& links,
         const StillFails& still_fails)
      : times_(times), links_(links), still_fails_(still_fails) {}

  /// Tests the events from `first` up to, but without, `last`.
  bool fails(std::size_t first, std::size_t last, const std::vector<std::string>& only) {
    if (done_.broken_off) return false;
    Selection part;
    part.only = only == links_ ? std::vector<std::string>{} : only;
    if (first > 0) part.from = times_[first] - times_.front();
    if (last < times_.size()) part.to = times_[last] - times_.front();
    ++done_.runs;
    const auto answer = still_fails_(part);
    done_.broken_off = !answer;
    if (!answer.value_or(false)) return false;
    done_.part = part;
    done_.events = last - first;
    return true;
  }

  Bisected run() {
    std::size_t first = 0, last = times_.size();
    done_.fails_at_all = fails(first, last, links_);
    if (!done_.fails_at_all) return done_;
    last = least(first + 1, last, [&](std::size_t end) { return fails(first, end, links_); });
    first = most(first, last - 1, [&](std::size_t begin) { return fails(begin, last, links_); });
    std::vector<std::string> only = links_;
    for (const auto& link : links_) {
      auto fewer = only;
      std::erase(fewer, link);
      if (!fewer.empty() && fails(first, last, fewer)) only = std::move(fewer);
    }
    return done_;
  }

 private:
  /// The least value that fails. `high` fails.
  template <class Fails>
  static std::size_t least(std::size_t low, std::size_t high, Fails fails) {
    while (low < high) {
      const std::size_t middle = low + (high - low) / 2;
      if (fails(middle))
        high = middle;
      else
        low = middle + 1;
    }
    return high;
  }
  /// The greatest value that fails. `low` fails.
  template <class Fails>
  static std::size_t most(std::size_t low, std::size_t high, Fails fails) {
    while (low < high) {
      const std::size_t middle = high - (high - low) / 2;
      if (fails(middle))
        low = middle;
      else
        high = middle - 1;
    }
    return low;
  }

  const std::vector<Stamp>& times_;
  const std::vector<std::string>& links_;
  const StillFails& still_fails_;
  Bisected done_;
};

}  // namespace

Bisected bisect(const std::vector<Stamp>& times, const std::vector<std::string>& links,
                const StillFails& still_fails) {
  return Search(times, links, still_fails).run();
}

}  // namespace drydock::slice
