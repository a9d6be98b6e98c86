#include "drivers/bus/configuration.hpp"

#include "drivers/bus/participant.hpp"

namespace drydock::bus {
namespace {

/// Discovers by unicast among the first hundred participants of this host. Nothing leaves the host.
constexpr const char* loopback_only = R"(
<CycloneDDS><Domain Id="any">
  <General>
    <Interfaces><NetworkInterface name="lo" multicast="false"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
  </General>
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <MaxAutoParticipantIndex>100</MaxAutoParticipantIndex>
    <Peers><Peer Address="127.0.0.1"/></Peers>
  </Discovery>
</Domain></CycloneDDS>)";

}  // namespace

std::string cyclone_configuration(const std::string& interface) {
  if (interface == loopback_interface) return loopback_only;
  // The default of every Cyclone program on that interface: others find it by multicast.
  return "<CycloneDDS><Domain Id=\"any\"><General><Interfaces><NetworkInterface name=\"" +
         interface + "\"/></Interfaces></General></Domain></CycloneDDS>";
}

}  // namespace drydock::bus
