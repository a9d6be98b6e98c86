#include <drydock/drivers/wire/dvl/pd0.hpp>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

int main(int, char** argv) {
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(file), {}};
  drydock::wire::Framer<drydock::wire::Pd0::max_frame> framer;
  framer.feed(bytes, drydock::wire::Pd0::scan, [](drydock::wire::Bytes frame, std::size_t) {
    if (const auto message = drydock::wire::Pd0::decode(frame))
      std::cout << std::get<0>(*message).variable.ensemble << "\n";
  });
}
