#include "drivers/bus/participant.hpp"

#include <dds/dds.h>

#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <utility>

#include "drivers/bus/configuration.hpp"
#include "drivers/bus/loopback_sockets.hpp"

namespace drydock::bus {
namespace {

Entity make_domain(std::uint32_t id, const std::string& interface) {
  const std::string name = "domain " + std::to_string(id) + " on the interface " + interface;
  const std::string configuration = cyclone_configuration(interface);
  if (interface != loopback_interface) return {dds_create_domain(id, configuration.c_str()), name};
  const LoopbackSockets sockets;
  Entity domain(dds_create_domain(id, configuration.c_str()), name);
  sockets.keep_new_ones_to_loopback();
  return domain;
}

/// A domain can be configured only once per process. Deleting it deletes everything in it.
std::shared_ptr<Entity> domain_on(std::uint32_t id, const std::string& interface) {
  static std::mutex mutex;
  static std::map<std::pair<std::uint32_t, std::string>, std::weak_ptr<Entity>> domains;
  const std::lock_guard lock(mutex);
  auto& known = domains[{id, interface}];
  auto domain = known.lock();
  if (!domain) {
    domain = std::make_shared<Entity>(make_domain(id, interface));
    known = domain;
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

Participant::Participant(std::uint32_t domain, const std::string& interface)
    : domain_(configured_by_user() ? nullptr : domain_on(domain, interface)),
      participant_(make_participant(domain)) {}

}  // namespace drydock::bus
