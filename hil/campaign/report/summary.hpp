#pragma once

#include <string>
#include <vector>

#include "hil/campaign/report/analysis.hpp"
#include "hil/campaign/report/earlier.hpp"
#include "hil/report/table.hpp"

namespace drydock::campaign {

/// All that the report says.
struct Summary {
  const Results* results = nullptr;  // outlives the summary
  std::string path;                  ///< of the campaign's file, for commands
  std::vector<FigureAnalysis> figures;
  std::vector<FigureShift> shifts;  ///< since an earlier campaign; empty: none was given
};

/// docs/use/campaign.md describes its keys. Equal results give equal bytes.
std::string to_json_text(const Summary& summary);

std::vector<report::Table> tables_of(const Summary& summary);

/// A page with the tables and the distribution of each figure, beside each parameter that is a
/// number.
std::string to_page(const Summary& summary);

}  // namespace drydock::campaign
