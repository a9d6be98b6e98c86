#include "hil/study/run/study_page.hpp"

#include <fmt/format.h>

#include "hil/report/html.hpp"

namespace drydock::study {

std::string page_of(const Study& study, const Options& options, const Result& result) {
  std::string body = fmt::format("<p class=soft>{} of {} runs, seed {}</p>\n", result.runs,
                                 options.runs, options.seed);
  for (const auto& table : result.tables) body += report::to_html(table);
  if (!result.figures.empty()) body += "<h2>Figures</h2>\n";
  for (const auto& figure : result.figures) body += report::html::figure(figure);
  return report::html::page(std::string(study.title), body);
}

}  // namespace drydock::study
