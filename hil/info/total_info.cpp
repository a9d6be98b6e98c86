#include "hil/info/total_info.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "drivers/terminal/data_size.hpp"
#include "hil/info/utc.hpp"

namespace drydock::info {
namespace {

double spanned_s(const TotalInfo& total) {
  return total.first ? std::chrono::duration<double>(*total.last - *total.first).count() : 0;
}

}  // namespace

void TotalInfo::add(const TotalInfo& other) {
  files += other.files;
  size += other.size;
  frames += other.frames;
  messages += other.messages;
  if (!other.first) return;
  first = first ? std::min(*first, *other.first) : *other.first;
  last = last ? std::max(*last, *other.last) : *other.last;
}

std::string to_text(const TotalInfo& total) {
  std::string text =
      fmt::format("total: {} files, {}", total.files, terminal::data_size_text(total.size));
  if (total.frames > 0) text += fmt::format(", {} frames", total.frames);
  if (total.messages > 0) text += fmt::format(", {} messages", total.messages);
  if (spanned_s(total) > 0) text += fmt::format(", {:.1f} s", spanned_s(total));
  if (total.first) text += utc::from(*total.first);
  return text + "\n";
}

std::string to_json(const TotalInfo& total) {
  const nlohmann::json json{{"files", total.files},
                            {"size", total.size},
                            {"frames", total.frames},
                            {"messages", total.messages},
                            {"begin", total.first ? utc::text(*total.first) : ""},
                            {"duration_s", spanned_s(total)}};
  return json.dump();
}

}  // namespace drydock::info
