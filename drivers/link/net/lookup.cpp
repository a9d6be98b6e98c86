#include "drivers/link/net/lookup.hpp"

#include <netdb.h>
#include <poll.h>
#include <sys/eventfd.h>

#include <boost/asio/ip/tcp.hpp>
#include <cstring>
#include <map>
#include <system_error>
#include <thread>

namespace drydock::link {
namespace {

/// Values are those of getaddrinfo (EAI_...), and no_answer_yet.
class NameCategory final : public std::error_category {
 public:
  static constexpr int no_answer_yet = 1;  // the C library's are negative

  const char* name() const noexcept override { return "host name"; }
  std::string message(int value) const override {
    if (value == no_answer_yet)
      return "the name server does not answer: mend it, or write the address in numbers";
    return "the host's name has no address (" + std::string(::gai_strerror(value)) +
           "): correct the name, or write the address in numbers";
  }
};

/// The category is never destroyed: a look-up may still hang when the program ends.
boost::system::error_code name_error(int value) {
  static const auto& category = *new NameCategory;
  return std::error_code(value, category);
}

asio::ip::address address_of(const addrinfo& info) {
  asio::ip::tcp::endpoint endpoint;
  endpoint.resize(info.ai_addrlen);
  std::memcpy(endpoint.data(), info.ai_addr, info.ai_addrlen);
  return endpoint.address();
}

/// Waits as long as the C library does: up to half a minute, if the name server is dead.
Lookup::Answer ask(const std::string& host) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;  // or each address would come once for each kind of socket
  hints.ai_flags = AI_ADDRCONFIG;
  addrinfo* found = nullptr;
  if (const int error = ::getaddrinfo(host.c_str(), nullptr, &hints, &found); error != 0)
    return name_error(error);
  Addresses addresses;
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next)
    addresses.push_back(address_of(*one));
  ::freeaddrinfo(found);
  if (addresses.empty()) return name_error(EAI_NONAME);
  return addresses;
}

struct Name {
  std::weak_ptr<Lookup> running;
  Addresses last_good;
};

struct Names {
  std::mutex mutex;  ///< protects by_host
  std::map<std::string, Name> by_host;
};

/// They are never destroyed: a look-up may still hang when the program ends.
Names& names() {
  static auto& all = *new Names;
  return all;
}

}  // namespace

Lookup::Lookup() : bell_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

std::shared_ptr<Lookup> Lookup::of(const std::string& host) {
  const std::lock_guard lock(names().mutex);
  auto& running = names().by_host[host].running;
  if (auto lookup = running.lock(); lookup && !lookup->answer()) return lookup;
  std::shared_ptr<Lookup> fresh(new Lookup);
  running = fresh;
  try {
    std::thread([fresh, host] { fresh->begin(host); }).detach();
  } catch (const std::system_error& no_thread) {
    fresh->finish(system_error(no_thread.code().value()));
  }
  return fresh;
}

void Lookup::begin(const std::string& host) {
  Answer answer = ask(host);
  if (answer) {
    const std::lock_guard lock(names().mutex);
    names().by_host[host].last_good = *answer;
  }
  finish(std::move(answer));
}

void Lookup::finish(Answer answer) {
  {
    const std::lock_guard lock(mutex_);
    answer_ = std::move(answer);
  }
  ::eventfd_write(bell_.get(), 1);
}

std::optional<Lookup::Answer> Lookup::answer() const {
  const std::lock_guard lock(mutex_);
  return answer_;
}

Descriptor Lookup::bell() const { return Descriptor(::dup(bell_.get())); }

void Lookup::wait(std::chrono::milliseconds limit) const {
  pollfd one{bell_.get(), POLLIN, 0};
  ::poll(&one, 1, static_cast<int>(limit.count()));
}

Addresses last_good_answer(const std::string& host) {
  const std::lock_guard lock(names().mutex);
  return names().by_host[host].last_good;
}

boost::system::error_code no_answer() { return name_error(NameCategory::no_answer_yet); }

}  // namespace drydock::link
