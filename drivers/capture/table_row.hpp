#pragma once

#include <boost/container/static_vector.hpp>
#include <string_view>

namespace drydock::capture {

/// The fields of a line of a table, without the quotation marks around them. Those behind the first
/// 96, and one that is cut before its second mark, are left out.
using TableRow = boost::container::static_vector<std::string_view, 96>;
TableRow row_of(std::string_view line, char separator);

/// The character behind the first field: a comma, a semicolon or a tabulator. 0: none of these.
char separator_of(std::string_view head);

}  // namespace drydock::capture
