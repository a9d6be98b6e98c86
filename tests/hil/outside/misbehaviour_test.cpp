// What a program does wrong is a line, a verdict and a count, and the run goes on to its end.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "hil/summary/junit.hpp"
#include "tests/hil/outside/outside_rig.hpp"

namespace misbehaviour_test {

using namespace outside_rig;
using testing::HasSubstr;

const std::string level = "{'roll_deg': 0.0, 'pitch_deg': 0.0}";

struct Run {
  drydock::summary::Summary summary;
  std::string said;
  const drydock::pipeline::PeerAccount& program() const {
    return summary.estimators.at(0).program.value();
  }
  const drydock::summary::Verdict& verdict() const { return summary.verdicts.at(0); }
};

/// Five seconds of a rig, whose first verdict is that on the program.
Run with(const std::string& client_text, const std::string& more = {},
         const std::string& command = R"(["python3", "client.py"])") {
  const Folder folder;
  Run run;
  run.summary = outside_rig::run(folder, one_imu + estimator("attitude", more, command),
                                 client_text, 5, &run.said);
  EXPECT_EQ(run.summary.duration_s, 5) << "no hang, and the bench goes on";
  EXPECT_EQ(run.verdict().subject, "mine");
  EXPECT_EQ(run.verdict().what, "answers");
  return run;
}

TEST(OutsideProgram, ThatAnswersWellPasses) {
  const auto run = with(client(level));
  EXPECT_TRUE(run.verdict().passed) << run.verdict().measured;
  EXPECT_EQ(run.program().faults(), 0U);
  EXPECT_THAT(run.said, testing::Not(HasSubstr("its program")));
}

TEST(OutsideProgram, ThatHangsIsKilledAndSaid) {
  const auto run =
      with(client(level, "say(said) if n < 10 else time.sleep(1000)"), "answer_within_s = 0.2");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.program().failure, HasSubstr("did not answer within 1 s at 0.450 s"));
  EXPECT_THAT(run.said, HasSubstr("mine: its program did not answer within 1 s"));
  EXPECT_EQ(run.program().answers, 9U);
  EXPECT_EQ(run.program().steps, 10U);
}

TEST(OutsideProgram, ThatDiesHasItsExitCodeInTheVerdict) {
  const auto run = with(client(level, "say(said) if n < 10 else os._exit(7)"));
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.verdict().measured, HasSubstr("9 to 10 steps; exited with code 7 at 0.45"));
  EXPECT_THAT(run.said, HasSubstr("0.450 s mine: its program exited with code 7"));
}

TEST(OutsideProgram, ThatDoesNotExistIsSaid) {
  const auto run = with("", "", R"(["./there-is-no-such-program"])");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.verdict().measured,
              HasSubstr("cannot start ./there-is-no-such-program: No such file or directory"));
}

TEST(OutsideProgram, ThatAnswersLateIsCountedAndUsed) {
  const auto run = with(client(level, "(time.sleep(0.3) if n == 10 else None, say(said))"),
                        "answer_within_s = 0.2");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().late, 1U);
  EXPECT_EQ(run.program().answers, run.program().steps);
  EXPECT_EQ(run.summary.estimators[0].estimates, run.summary.devices.at(0).messages);
  EXPECT_GE(run.program().longest_s, 0.3);
}

TEST(OutsideProgram, ThatAnswersTwiceIsHeardOnce) {
  const auto run = with(client(level, "(say(said), say(said) if n == 10 else None)"));
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_EQ(run.program().twice, 1U);
  EXPECT_EQ(run.program().answers, run.program().steps);
  EXPECT_EQ(run.summary.estimators[0].estimates, run.summary.devices.at(0).messages);
  EXPECT_THAT(run.said, HasSubstr("answered step 10 twice"));
}

TEST(OutsideProgram, ThatGivesNanLosesThatStepAlone) {
  const auto run =
      with(client("{'roll_deg': float('nan') if 1.0 <= t < 1.049 else 0.0, 'pitch_deg': 0.0}"));
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_GE(run.program().not_finite, 1U);
  EXPECT_LE(run.program().not_finite, 2U);
  EXPECT_EQ(run.program().answers, run.program().steps);
  const auto samples = run.summary.devices.at(0).messages;
  EXPECT_GE(run.summary.estimators[0].estimates, samples - 10);
  EXPECT_LT(run.summary.estimators[0].estimates, samples);
  EXPECT_NEAR(run.summary.estimators[0].whole_run->roll_rms_deg, 0, 1e-6);
  EXPECT_THAT(run.said, HasSubstr("answered with roll_deg: NaN, which JSON does not have"));
}

TEST(OutsideProgram, ThatTellsTheFutureIsNotBelieved) {
  const auto run =
      with(client("{'roll_deg': 0.0, 'pitch_deg': 0.0, "
                  "'valid_at_ns': m['valid_at_ns'] + (10**12 if t < 1 else 0)}"));
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_NEAR(static_cast<double>(run.program().out_of_time), 100, 2);
  EXPECT_THAT(run.said, HasSubstr(" s after the end of its step"));
  EXPECT_NEAR(run.summary.estimators[0].whole_run->roll_rms_deg, 0, 1e-6);
}

TEST(OutsideProgram, ThatSpeaksAnotherVersionIsEnded) {
  const auto run = with("import sys\nprint('{\"drydock\":2}', flush=True)\nsys.stdin.read()\n");
  EXPECT_FALSE(run.verdict().passed);
  EXPECT_THAT(run.verdict().measured, HasSubstr("speaks version 2 of the protocol, allowed: 1"));
}

TEST(OutsideProgram, ThatWritesWithoutEndOfLineIsEnded) {
  const auto run = with(
      "import sys\nprint('{\"drydock\":1}', flush=True)\n"
      "sys.stdout.write('x' * 17000000)\nsys.stdout.flush()\nsys.stdin.read()\n");
  EXPECT_THAT(run.verdict().measured, HasSubstr("without an end of line"));
}

TEST(OutsideProgram, ThatTellsThePastIsNotBelieved) {
  const auto run =
      with(client("{'roll_deg': 0.0, 'pitch_deg': 0.0, "
                  "'valid_at_ns': m['valid_at_ns'] - (10**9 if t > 2 else 0)}"));
  EXPECT_NEAR(static_cast<double>(run.program().out_of_time), 100, 2) << "1 s until it is newer";
  EXPECT_THAT(run.said,
              HasSubstr(" s before the end of its step, which is before its last estimate"));
}

/// ESC and a byte that is no UTF-8, in the greeting and in an answer.
TEST(OutsideProgram, ThatWritesAnyBytesIsQuotedAsTextEverywhere) {
  const std::string bytes = "b'hi \\xff\\xfe <&> \\x01\\x1b[31mred\\n'";
  const std::string write = "sys.stdout.buffer.write(" + bytes + "); sys.stdout.flush()";
  const std::string quoted = "\"hi ?? <&> ??[31mred\"";
  const auto greeting = with("import sys\n" + write + "\nsys.stdin.read()\n");
  EXPECT_THAT(greeting.said, HasSubstr(quoted));
  EXPECT_THAT(greeting.verdict().measured, HasSubstr(quoted));
  EXPECT_THAT(to_json(greeting.summary), HasSubstr("hi ?? <&> ??[31mred"));
  EXPECT_THAT(to_junit(greeting.summary, "rig.toml"), HasSubstr("hi ?? &lt;&amp;&gt; ??[31mred"));
  const auto answer = with(client(level, "say(said) if n != 9 else (sys.stdout.buffer.write(" +
                                             bytes + "), sys.stdout.flush())"));
  EXPECT_THAT(answer.said, HasSubstr(quoted + ", which is not JSON"));
}

TEST(OutsideProgram, ItsVerdictIsInJunitToo) {
  const auto run = with(client(level, "say(said) if n < 10 else os._exit(7)"));
  EXPECT_THAT(to_junit(run.summary, "rig.toml"), HasSubstr("exited with code 7"));
  EXPECT_THAT(to_text(run.summary), HasSubstr("FAIL mine answers: 9 to 10 steps"));
}

}  // namespace misbehaviour_test
