#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

namespace drydock::wire::described {
struct Description;
}

namespace drydock::decode {

struct DecodeOptions {
  std::string protocol;  ///< a name of drivers/wire/registry.hpp, or that of `description`
  std::string file;      ///< empty or "-": standard input
  bool count = false;    ///< print the number of messages of each type, not the messages
  bool quiet = false;    ///< no totals on `err`
  std::string format{};  ///< one of decode_formats(); empty: recognised by content
  std::shared_ptr<const wire::described::Description> description{};  ///< null: of the registry
  std::string interface {};  ///< of a pcapng file with several serial lines
  std::string dbc{};         ///< a DBC file in place of a protocol; empty: none
  std::string pgns{};        ///< a table of PGNs (canboat.json) in place of a protocol; empty: none
  std::vector<std::string> more{};  ///< files that go on where `file` ends, in their order
};

/// `drydock decode`: reads a capture, or the files into which one was cut, and writes JSON Lines,
/// one object for each message. Byte protocols read the raw line and ignore anything else on it,
/// and also the comments at the head of the file (drivers/capture/comment_head.hpp). CAN protocols
/// and DBC files read every format of drivers/capture and add `time_s` and `interface`. Exit code:
/// 0 something was decoded, 1 nothing was decoded, the capture cannot be read or the output cannot
/// be written, 2 the protocol, the format or the DBC file is wrong.
int decode(const DecodeOptions& options, std::FILE* out, std::FILE* err);

/// Names for --protocol: "a, b, c".
std::string decode_protocols();
/// Those of them that a byte line carries, and those that a CAN bus carries.
std::string byte_protocols();
std::string frame_protocols();
/// Names for --format.
std::string decode_formats();

}  // namespace drydock::decode
