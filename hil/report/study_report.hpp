#pragma once

#include <string>

#include "hil/study/study.hpp"

namespace drydock::report {

/// Columns side by side. The first is aligned left, the others right. The text ends with a newline.
std::string to_text(const study::Table& table);

/// A heading, the table and its note.
std::string to_html(const study::Table& table);

/// The study's page: tables and every figure.
std::string to_html(const study::Study& study, const study::Options& options,
                    const study::Result& result);

}  // namespace drydock::report
