// The measurements of a recording, by the drivers of its rig: how many each device gave.
#include <drydock/drivers/recordings/record/player.hpp>
#include <iostream>
#include <map>

using namespace drydock;

struct Counter : device::Listener {
  std::map<unsigned, unsigned> messages;
  void on_measurement(const device::Measurement& one) override {
    ++messages[measurement::origin_of(one).device];
  }
  void on_state(const device::Device&, const device::Transition&) override {}
};

int main(int, char** argv) {
  Counter counter;
  const auto played = record::play(argv[1], {}, counter);
  if (!played) return std::cerr << played.error().line << "\n", 1;
  for (const auto& [device, count] : counter.messages) std::cout << device << " " << count << "\n";
}
