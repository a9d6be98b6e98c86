#pragma once

namespace drydock::program {

/// Call it before anything is opened or printed. A standard stream that is closed gets a descriptor
/// that no file can get instead: reading standard input and writing standard output fail as before,
/// messages go nowhere. From now on a message that cannot be written is no error, and what files
/// and devices say cannot steer a terminal: messages have no control characters but line ends, tabs
/// and those that erase a line.
void guard_standard_streams();

}  // namespace drydock::program
