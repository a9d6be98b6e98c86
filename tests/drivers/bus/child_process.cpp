#include "tests/drivers/bus/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <cstdio>

#include <algorithm>
#include <system_error>
#include <thread>

#include "tests/drivers/bus/bus_fixture.hpp"
#include "tests/drivers/bus/hostile_writer.hpp"

extern char** environ;

namespace drydock::bus::test {
namespace {

void say(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

/// Publishes samples whose x is their number, one each millisecond, as a fast IMU does. It says
/// when it sees all readers and begins with SIGUSR1: they see its writers later than it sees them.
void publish_numbered(std::uint32_t domain, int count) {
  sigset_t begin;
  ::sigemptyset(&begin);
  ::sigaddset(&begin, SIGUSR1);
  ::pthread_sigmask(SIG_BLOCK, &begin, nullptr);
  const Participant participant(domain);
  Publisher publisher(participant, all_devices(Provenance::replayed));
  if (!eventually([&] { return publisher.matched_readers() == 8; })) return;
  say("matched");
  int received = 0;
  ::sigwait(&begin, &received);
  for (int i = 0; i < count; ++i) {
    auto sample = only_origin<measurement::ImuSample>(Index::imu);
    sample.origin.provenance = Provenance::replayed;
    sample.specific_force.x() = i;
    publisher.publish(Measurement{sample});
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  say("published");
  ::pause();
}

/// Says when it is there, then when it sees all writers: they see its readers earlier.
void subscribe(std::uint32_t domain) {
  const Participant participant(domain);
  Subscriber subscriber(participant, all_devices());
  say("subscribed");
  if (!eventually([&] { return subscriber.matched_writers() == 8; })) return;
  say("matched");
  std::size_t taken = 0;
  for (double last = -1; last < end_of_numbers;) {
    for (const auto& measurement : take(subscriber, 1)) {
      last = std::get<measurement::ImuSample>(measurement).specific_force.x();
      ++taken;
    }
  }
  say(std::to_string(taken));
  ::pause();
}

}  // namespace

ChildProcess::ChildProcess(std::vector<std::string> arguments) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category());
  arguments.insert(arguments.begin(), "bus_test");
  std::vector<char*> argv;
  std::ranges::transform(arguments, std::back_inserter(argv), [](auto& a) { return a.data(); });
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
  const int error = ::posix_spawn(&pid_, "/proc/self/exe", &actions, nullptr, argv.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::close(ends[1]);
  output_ = ends[0];
  if (error != 0) throw std::system_error(error, std::generic_category());
}

ChildProcess::~ChildProcess() {
  signal(SIGKILL);
  ::waitpid(pid_, nullptr, 0);
  ::close(output_);
}

std::string ChildProcess::read_line() const {
  std::string line;
  for (char c = 0; ::read(output_, &c, 1) == 1 && c != '\n';) line.push_back(c);
  return line;
}

void ChildProcess::signal(int number) const { ::kill(pid_, number); }

bool run_as_child(const std::vector<std::string>& arguments) {
  if (arguments.size() < 2) return false;
  const auto domain = static_cast<std::uint32_t>(std::stoul(arguments[1]));
  if (arguments[0] == "publish") {
    publish_numbered(domain, std::stoi(arguments.at(2)));
  } else if (arguments[0] == "subscribe") {
    subscribe(domain);
  } else if (arguments[0] == "garbage") {
    write_garbage(domain, [] {
      say("written");
      ::pause();
    });
  }
  return true;
}

}  // namespace drydock::bus::test
