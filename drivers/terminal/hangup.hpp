#pragma once

namespace drydock::terminal {

/// True if the parent of this program had SIGHUP ignored, as `nohup` does: then no command ends at
/// a hang-up. The first call looks; it must come before anything here changes that signal.
bool hangup_is_ignored();

}  // namespace drydock::terminal
