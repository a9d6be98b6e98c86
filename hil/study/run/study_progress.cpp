#include "hil/study/run/study_progress.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "drivers/terminal/progress_bar.hpp"
#include "drivers/terminal/terminal_screen.hpp"

namespace drydock::study {
namespace {

double seconds_between(std::chrono::steady_clock::time_point from,
                       std::chrono::steady_clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

/// 75 -> "1 min 15 s"
std::string spoken(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

StudyProgress::StudyProgress(std::FILE* out)
    : out_(out), terminal_(terminal::erases_lines(fileno(out))) {}

void StudyProgress::on_run(std::string_view campaign, std::size_t done, std::size_t of) {
  constexpr auto between_drawings = std::chrono::milliseconds{100};
  if (!terminal_) return;
  const auto now = Clock::now();
  if (done < of && now < next_drawing_) return;
  next_drawing_ = now + between_drawings;
  const double left = seconds_between(campaign_begin_, now) * static_cast<double>(of - done) /
                      static_cast<double>(done);
  fmt::print(out_, "{}{} {} {} of {} runs, {} left, Ctrl-C ends with the runs done",
             terminal::wipe_line, campaign,
             terminal::progress_bar(static_cast<double>(done) / static_cast<double>(of)), done, of,
             spoken(left));
  std::fflush(out_);
  if (done == of) campaign_begin_ = now;
}

void StudyProgress::finish(std::string_view study, std::size_t runs, const study::Options& options,
                           std::size_t earlier) {
  fmt::print(out_, "{}{}: {} of {} runs{}, seed {}, {:.1f} s{}\n",
             terminal_ ? terminal::wipe_line : "", study, earlier + runs, options.runs,
             earlier > 0 ? fmt::format(", {} of them from before", earlier) : "", options.seed,
             seconds_between(begin_, Clock::now()), stopped() ? ", ended by Ctrl-C" : "");
}

}  // namespace drydock::study
