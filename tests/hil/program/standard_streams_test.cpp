// What a file says steers no terminal, and a stream that is closed is no file and no abort.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/hil/program/program.hpp"

namespace standard_streams_test {

using program::drydock;
using program::Folder;
using testing::HasSubstr;
using testing::Not;

const std::string dive = DRYDOCK_SOURCE_DIR "/fixtures/dives/dvl-finds-the-bottom/dive.mcap";

/// The exit code of a command whose streams are closed as the shell says.
int exit_code_of(const std::string& arguments) {
  const int status =
      std::system(("cd " DRYDOCK_SOURCE_DIR "; ( " DRYDOCK_PROGRAM " " + arguments + " )").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(StandardStreams, ClosedOrFullAreAFailureAndNoAbort) {
  EXPECT_EQ(exit_code_of("info " + dive + " >&- 2>&-"), 1);
  EXPECT_EQ(exit_code_of("info " + dive + " >/dev/full 2>/dev/full"), 1);
  EXPECT_EQ(exit_code_of("info no-such-file >/dev/null 2>&-"), 1);
  EXPECT_EQ(exit_code_of("info " + dive + " <&- >/dev/null 2>&-"), 0);
}

/// The first line comes before the devices run, the last one when they have: `head` is gone then.
TEST(StandardStreams, APipeThatIsClosedBeforeTheLastLineEndsACommandQuietly) {
  const auto cut = drydock("--version; bash -c '" DRYDOCK_PROGRAM
                           " emulate demo --for 2s | head -1; exit ${PIPESTATUS[0]}'");
  EXPECT_EQ(cut.exit_code, 0);
  EXPECT_THAT(cut.output, Not(HasSubstr("cannot be written")));
}

/// The first file that is opened would get the number of a closed stream, and its messages.
TEST(StandardStreams, OfAClosedErrorStreamNothingIsWrittenIntoAFile) {
  const Folder folder;
  const auto out = (folder / "out.log").string();
  EXPECT_EQ(exit_code_of("export " + dive + " --to pcapng -o " + out + " 2>&-"),
            exit_code_of("export " + dive + " --to pcapng -o " + out + "2 2>/dev/null"));
  EXPECT_EQ(program::read_file(out), program::read_file(out + "2"));
}

TEST(StandardStreams, NamesInAFileSteerNoTerminal) {
  const Folder folder;
  const auto log = (folder / "esc.log").string();
  std::ofstream(log) << "(1.0) can\x1b]0;X\x07 18EEFF01#05A04FFA008296C0\n"
                        "(2.0) can0 18EEFF01#05A04FFA008296C0\n";
  for (const std::string command : {"info ", "decode --protocol nmea2000 ", "decode --dbc "}) {
    const auto said = drydock(command + log).output;
    EXPECT_THAT(said, Not(HasSubstr("\x1b"))) << command;
    EXPECT_THAT(said, Not(HasSubstr("\x07"))) << command;
  }
  const auto missing = drydock("info $'no\\x1b[31m.log'").output;
  EXPECT_THAT(missing, Not(HasSubstr("\x1b")));
}

TEST(StandardStreams, InfoFailsOnAFileThatHoldsNothing) {
  const Folder folder;
  const auto log = (folder / "cut.blf").string();
  std::ofstream blf(log, std::ios::binary);
  std::string head = "LOGG";
  head += std::string{char(144), 0, 0, 0};
  head.resize(144, '\0');
  blf << head;
  blf.close();
  EXPECT_EQ(drydock("info " + log).exit_code, 1) << "a BLF of no object";
}

}  // namespace standard_streams_test
