#include "drivers/bus/participant.hpp"

#include <dds/dds.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <string>

namespace drydock::bus {
namespace {

/// Discovery by unicast among the first hundred participants of this host; nothing leaves it.
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

/// A domain can be configured once per process, and deleting it deletes all that is in it.
std::shared_ptr<Entity> loopback_domain(std::uint32_t id) {
  static std::mutex mutex;
  static std::map<std::uint32_t, std::weak_ptr<Entity>> domains;
  const std::lock_guard lock(mutex);
  auto domain = domains[id].lock();
  if (!domain) {
    domain =
        std::make_shared<Entity>(dds_create_domain(id, loopback_only),
                                 "domain " + std::to_string(id) + " on the loopback interface");
    domains[id] = domain;
  }
  return domain;
}

bool configured_by_user() {
  const char* const uri = std::getenv("CYCLONEDDS_URI");
  return uri != nullptr && *uri != '\0';
}

Entity make_participant(std::uint32_t domain) {
  constexpr std::string_view enclave = "enclave=/;";
  const Qos qos(dds_create_qos());
  dds_qset_userdata(qos.get(), enclave.data(), enclave.size());
  return Entity(dds_create_participant(domain, qos.get(), nullptr),
                "participant in domain " + std::to_string(domain));
}

}  // namespace

Participant::Participant(std::uint32_t domain, Reach reach)
    : domain_(reach == Reach::this_host && !configured_by_user() ? loopback_domain(domain)
                                                                 : nullptr),
      participant_(make_participant(domain)) {}

}  // namespace drydock::bus
