#include "hil/summary/program_verdict.hpp"

#include <fmt/format.h>

namespace drydock::summary {
namespace {

std::string faults_text(const pipeline::PeerAccount& program) {
  std::string out = program.failure;
  const auto add = [&out](std::uint64_t count, const char* what) {
    if (count > 0) out += fmt::format("{}{} {}", out.empty() ? "" : ", ", count, what);
  };
  add(program.late, "late");
  add(program.twice, "twice or not in turn");
  add(program.malformed, "malformed");
  add(program.not_finite, "not finite");
  add(program.out_of_time, "out of time");
  return out;
}

/// Of a topic: that something came, and that it was sound.
Verdict verdict_of_topic(const std::string& estimator, const pipeline::PeerAccount& program) {
  const std::string faults = faults_text(program);
  return {.subject = estimator,
          .what = "answers",
          .measured =
              fmt::format("{} messages{}{}", program.answers, faults.empty() ? "" : "; ", faults),
          .expected = "messages, in time and finite",
          .passed = program.answers > 0 && program.faults() == 0};
}

}  // namespace

Verdict verdict_of(const std::string& estimator, const pipeline::PeerAccount& program) {
  if (!program.in_steps) return verdict_of_topic(estimator, program);
  const bool all = program.steps > 0 && program.answers == program.steps;
  const std::string faults = faults_text(program);
  return {.subject = estimator,
          .what = "answers",
          .measured = fmt::format("{} to {} steps{}{}", program.answers, program.steps,
                                  faults.empty() ? "" : "; ", faults),
          .expected = "one to each step, in time and finite",
          .passed = all && program.faults() == 0};
}

std::string program_text(const pipeline::PeerAccount& program) {
  constexpr double ms = 1e3;
  if (!program.in_steps)
    return fmt::format(", {} messages, sent after {:.3f} ms ({:.3f} at most)", program.answers,
                       program.mean_s * ms, program.longest_s * ms);
  return fmt::format(", {} of {} steps answered after {:.3f} ms ({:.3f} at most)", program.answers,
                     program.steps, program.mean_s * ms, program.longest_s * ms);
}

nlohmann::ordered_json program_json(const pipeline::PeerAccount& program) {
  using Json = nlohmann::ordered_json;
  return {{"steps", program.steps},
          {"answers", program.answers},
          {"mean_s", program.mean_s},
          {"longest_s", program.longest_s},
          {"late", program.late},
          {"twice", program.twice},
          {"malformed", program.malformed},
          {"not_finite", program.not_finite},
          {"out_of_time", program.out_of_time},
          {"failure", program.failure.empty() ? Json(nullptr) : Json(program.failure)}};
}

}  // namespace drydock::summary
