#pragma once

#include <cstdio>
#include <string>

namespace drydock::decode {

struct DecodeOptions {
  std::string protocol;  ///< a name of drivers/wire/registry.hpp
  std::string file;      ///< empty or "-": standard input
  bool count = false;    ///< print how many messages of each type there are, not the messages
  bool quiet = false;    ///< no totals on `err`
  std::string format{};  ///< one of decode_formats(); empty: recognised by content
};

/// `drydock decode`: a capture in, JSON Lines out, one object per message. Byte protocols read the
/// raw line, whatever else is on it, without the '#' lines that its file may begin with; CAN
/// protocols read any format of drivers/capture and add `time_s` and `interface`. Exit code: 0
/// something was decoded, 1 nothing was, 2 unknown protocol or format, the file cannot be read or
/// the output not written.
int decode(const DecodeOptions& options, std::FILE* out, std::FILE* err);

/// Names for --protocol, "a, b, c".
std::string decode_protocols();
/// Names for --format.
std::string decode_formats();

}  // namespace drydock::decode
