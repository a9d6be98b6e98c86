#pragma once

#include <string_view>

namespace drydock::report {

/// The style of a page, and the script that draws its figures. The program contains them.
std::string_view page_style();
std::string_view page_script();

}  // namespace drydock::report
