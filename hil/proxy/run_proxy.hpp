#pragma once

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>

namespace drydock::wire::described {
struct Description;
}

namespace drydock::proxy {

struct ProxyCommandOptions {
  std::string real, virt;  ///< link URIs
  std::string faults;      ///< a file of blocks [[fault]]; empty: none
  std::string protocol;    ///< as in a rig file; "can" for every frame of a CAN bus
  std::shared_ptr<const wire::described::Description> description{};  ///< of `protocol`, if a file
  std::string device = "device";  ///< the device name in the fault file
  int address = 0;                ///< on a bus; 0: any
  std::uint64_t seed = 1;
  double duration_s = 0;  ///< 0: until Ctrl-C
  bool json = false;      ///< prints the summary as JSON
};

/// `drydock proxy`: connects a real device's link to a virtual link and puts faults between them.
/// Prints a line on `err` when either side changes, and the summary on `out`. Exit code: 0; 2 for
/// wrong usage.
int proxy(const ProxyCommandOptions& options, std::FILE* out, std::FILE* err);

}  // namespace drydock::proxy
