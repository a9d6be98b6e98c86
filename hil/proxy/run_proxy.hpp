#pragma once

#include <cstdint>
#include <cstdio>
#include <string>

namespace drydock::proxy {

struct ProxyCommandOptions {
  std::string real, virt;         ///< link URIs
  std::string faults;             ///< a file of blocks [[fault]]; empty: none
  std::string protocol;           ///< as in a rig file; of a CAN bus "can": every frame
  std::string device = "device";  ///< the name that the faults have
  int address = 0;                ///< on a bus; 0: any
  std::uint64_t seed = 1;
  double duration_s = 0;  ///< 0: until Ctrl-C
  bool json = false;      ///< the summary
};

/// `drydock proxy`: passes a real device's link on to a virtual one, faults between. A line a
/// change of either side on `err`, the summary on `out`. Exit code: 0; 2 for what cannot be.
int proxy(const ProxyCommandOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::proxy
