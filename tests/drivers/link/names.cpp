#include "tests/drivers/link/names.hpp"

#include <dlfcn.h>
#include <netdb.h>

#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <set>

namespace drydock::link::testing::names {
namespace {

struct Server {
  std::mutex mutex;
  std::condition_variable changed;
  std::map<std::string, std::vector<std::string>, std::less<>> answers;
  std::set<std::string, std::less<>> hung;
  int hanging = 0, lookups = 0;
};

/// It is never destroyed: a look-up may outlive main().
Server& server() {
  static auto& one = *new Server;
  return one;
}

using GetAddrInfo = int (*)(const char*, const char*, const addrinfo*, addrinfo**);

GetAddrInfo c_library() {
  static const auto found = reinterpret_cast<GetAddrInfo>(::dlsym(RTLD_NEXT, "getaddrinfo"));
  return found;
}

void wait_if_hung(Server& s, const std::string& host) {
  std::unique_lock lock(s.mutex);
  ++s.lookups;
  if (!s.hung.contains(host)) return;
  ++s.hanging;
  s.changed.wait_for(lock, std::chrono::seconds{3}, [&] { return !s.hung.contains(host); });
  --s.hanging;
  s.changed.notify_all();
}

std::vector<std::string> addresses_of(Server& s, const std::string& host) {
  const std::lock_guard lock(s.mutex);
  const auto known = s.answers.find(host);
  return known == s.answers.end() ? std::vector{host} : known->second;
}

/// The addresses one after another, as one list.
int chain(const std::vector<std::string>& addresses, const char* service, const addrinfo* hints,
          addrinfo** found) {
  *found = nullptr;
  addrinfo** end = found;
  for (const std::string& address : addresses) {
    if (const int error = c_library()(address.c_str(), service, hints, end); error != 0)
      return error;
    while (*end != nullptr) end = &(*end)->ai_next;
  }
  return 0;
}

}  // namespace

void answer(const std::string& host, const std::vector<std::string>& addresses) {
  const std::lock_guard lock(server().mutex);
  server().answers[host] = addresses;
}

void hang(const std::string& host) {
  const std::lock_guard lock(server().mutex);
  server().hung.insert(host);
}

void release() {
  std::unique_lock lock(server().mutex);
  server().hung.clear();
  server().changed.notify_all();
  server().changed.wait(lock, [] { return server().hanging == 0; });
}

int hanging() {
  const std::lock_guard lock(server().mutex);
  return server().hanging;
}

int lookups() {
  const std::lock_guard lock(server().mutex);
  return server().lookups;
}

}  // namespace drydock::link::testing::names

extern "C" int getaddrinfo(const char* host, const char* service, const addrinfo* hints,
                           addrinfo** found) {
  using namespace drydock::link::testing::names;
  Server& s = server();
  const std::string name = host == nullptr ? "" : host;
  wait_if_hung(s, name);
  if (name.empty()) return c_library()(host, service, hints, found);
  return chain(addresses_of(s, name), service, hints, found);
}
