#pragma once

#include <cstdio>
#include <string>

#include "hil/diagnose/outcome.hpp"

namespace drydock::diagnose {

struct DiagnoseOptions {
  std::string report;  ///< folder for index.html; empty: none
  bool json = false;
};

/// Prints an outcome and writes its report. Returns 0 if nothing was found, 1 if something was
/// found or a device was not heard.
int tell(const Outcome& outcome, const DiagnoseOptions& options, std::FILE* out);

}  // namespace drydock::diagnose
