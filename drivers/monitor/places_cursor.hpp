#pragma once

namespace drydock::monitor {

/// True if standard output is a terminal that can place its cursor; false on TERM=dumb and on an
/// unknown one.
bool places_cursor();

}  // namespace drydock::monitor
