#include <gtest/gtest.h>

#include "tests/drivers/bus/child_process.hpp"

int main(int argc, char** argv) {
  if (argc > 2 && argv[1] == std::string("--child")) {
    drydock::bus::test::run_as_child({argv + 2, argv + argc});
    return 0;
  }
  ::testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
