#pragma once

#include <cstdint>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "rig_config/rig.hpp"

/// Can this machine run a rig? Every check reads files under a root; the root is "/" except in
/// tests. A check reports what is wrong and the command that repairs it.
namespace drydock::doctor {

enum class Fitness : std::uint8_t {
  ok,
  advice,  ///< works, but could be better, or may be needed later
  wrong,   ///< the requested function will not work
};

struct Diagnosis {
  std::string check;  ///< "permissions", "modules", ...
  Fitness fitness = Fitness::ok;
  std::string text;     ///< the finding
  std::string command;  ///< repairs it; empty if nothing needs repair or no command can repair it
};

/// What a rig needs from the machine.
struct Needs {
  bool whole_machine = true;       ///< no rig was named: check all, report little as wrong
  std::string rig_file;            ///< whose text an advice may change; empty: there is none
  std::vector<std::string> ports;  ///< device paths of serial and slcan links
  std::vector<std::string> buses;  ///< CAN interfaces of socketcan links
  std::map<std::string, unsigned>
      bitrates;             ///< of these interfaces, bit/s, where the rig states it
  bool kernel_can = false;  ///< SocketCAN, for socketcan and vcan links
  bool can_auto = false;    ///< uses vcan if it is there, works without it
  bool dds = true;
};

Needs needs_of(const rig_config::Rig& rig);

std::vector<Diagnosis> check_ports(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_holders(const std::string& root, const Needs& needs);
/// Ports named by their order of plugging, though they have a name that stays.
std::vector<Diagnosis> check_names(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_latency(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_can(const std::string& root, const Needs& needs);
/// Serial and CAN adapters that are plugged in, but whose module is not loaded.
std::vector<Diagnosis> check_drivers(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_network(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_limits(const std::string& root);
std::vector<Diagnosis> check_disk(const std::string& folder);
/// `status` and `code` are those of adjtimex. Code -1: the kernel gave no answer.
std::vector<Diagnosis> check_clock(int code, int status);

std::vector<Diagnosis> diagnose(const std::string& root, const Needs& needs);

/// `drydock doctor`. Exit code: 0, or 1 if something is wrong.
int doctor(const Needs& needs, bool json, std::FILE* out);

}  // namespace drydock::doctor
