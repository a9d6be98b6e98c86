#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "rig_config/rig.hpp"

/// Is this machine fit for a rig? Every check reads files under a root, "/" but in tests, and says
/// what is wrong and the command that mends it.
namespace drydock::doctor {

enum class Fitness : std::uint8_t {
  ok,
  advice,  ///< works, but could be better, or may be wanted later
  wrong,   ///< what is asked for will not work
};

struct Diagnosis {
  std::string check;  ///< "permissions", "modules", ...
  Fitness fitness = Fitness::ok;
  std::string text;     ///< what was found
  std::string command;  ///< that mends it; empty where nothing is to be mended, or no command can
};

/// What a rig needs of the machine.
struct Needs {
  bool whole_machine = true;       ///< no rig was named: everything is looked at, little is wrong
  std::vector<std::string> ports;  ///< device paths of serial and slcan links
  std::vector<std::string> buses;  ///< CAN interfaces of socketcan links
  bool kernel_can = false;         ///< SocketCAN, for socketcan and vcan links
  bool can_auto = false;           ///< takes vcan where it is, can do without
  bool dds = true;
};

Needs needs_of(const rig_config::Rig& rig);

std::vector<Diagnosis> check_ports(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_holders(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_latency(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_can(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_network(const std::string& root, const Needs& needs);
std::vector<Diagnosis> check_limits(const std::string& root);
std::vector<Diagnosis> check_disk(const std::string& folder);
/// `status` and `code` as adjtimex gives them; code -1: the kernel would not say.
std::vector<Diagnosis> check_clock(int code, int status);

std::vector<Diagnosis> diagnose(const std::string& root, const Needs& needs);

/// `drydock doctor`. Exit code: 0, or 1 when something is wrong.
int doctor(const Needs& needs, bool json, std::FILE* out);

}  // namespace drydock::doctor
