#include "drivers/probe/describe.hpp"

#include <fmt/format.h>

#include <cstring>

#include "drivers/capture/file_blocks.hpp"
#include "drivers/survey/guess.hpp"
#include "drivers/terminal/exit_codes.hpp"

namespace drydock::probe {

int describe(const std::string& file, std::FILE* out, std::FILE* err) {
  constexpr std::size_t enough = 1u << 20;
  capture::FileBlocks blocks(file);
  std::vector<std::uint8_t> bytes;
  for (wire::Bytes block = blocks.read(); !block.empty() && bytes.size() < enough;
       block = blocks.read())
    bytes.insert(bytes.end(), block.begin(), block.end());
  if (blocks.error() != 0) {
    fmt::print(err, "describe: cannot read {}: {}\n", file, std::strerror(blocks.error()));
    return terminal::exit_failed;
  }
  const std::string guess = survey::guess_description(bytes);
  if (guess.empty())
    fmt::print(err, "describe: {}: {} bytes without sentences or frames that repeat; record more\n",
               file, bytes.size());
  fmt::print(out, "{}", guess);
  return terminal::exit_of(!guess.empty());
}

}  // namespace drydock::probe
