#pragma once

#include <string>

#include "hil/study/study.hpp"

namespace drydock::study {

/// The study's page: tables and every figure, as HTML.
std::string page_of(const Study& study, const Options& options, const Result& result);

}  // namespace drydock::study
