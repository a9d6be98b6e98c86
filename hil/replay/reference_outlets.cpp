#include "hil/replay/reference_outlets.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "hil/report/write_file.hpp"

namespace drydock::replay {

namespace {

std::string text_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw std::runtime_error(path + ": " + std::strerror(errno));
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Describes the part of the recording and the faults. References are valid only for the same text.
std::string part_text(const record::Selection& part,
                      const std::vector<rig_config::FaultConfig>& faults) {
  std::string text;
  for (const auto& name : part.only) text += (text.empty() ? "only " : ",") + name;
  if (part.from) text += fmt::format(" from {} ns", part.from->count());
  if (part.to) text += fmt::format(" to {} ns", part.to->count());
  if (text.empty()) text = "all";
  for (const auto& fault : faults)
    text += fmt::format("{} {} from {} s", &fault == &faults.front() ? ", with" : ",", fault.words,
                        fault.start_s);
  return text;
}

}  // namespace

ReferenceOutlets::ReferenceOutlets(const RigReplayOptions& options,
                                   const std::vector<rig_config::FaultConfig>& faults)
    : options_(options), part_(part_text(options.part, faults)) {
  if (!options.check.empty()) {
    auto expected = parse_references(text_of(options.check));
    if (!expected) throw std::runtime_error(options.check + ": " + expected.error().line);
    if (expected->part != part_)
      throw std::runtime_error(fmt::format("{} is of another part of a recording: {}; this is {}",
                                           options.check, expected->part, part_));
    check_.emplace(std::move(*expected), options.tolerance);
  }
  if (!options.update_refs.empty()) maker_.emplace(options.refs_every);
}

void ReferenceOutlets::follow(host::Followers& followers, const rig_config::Rig& rig) {
  if (check_) followers.add(checked_.emplace(*check_, rig));
  if (maker_) followers.add(made_.emplace(*maker_, rig));
}

bool ReferenceOutlets::finish(bool whole, std::FILE* err) {
  if (maker_ && whole) {
    report::write_file(options_.update_refs, to_json_text(maker_->made(part_)));
    fmt::print(err, "references written: {}\n", options_.update_refs);
  }
  if (!check_) return true;
  const auto diverged = check_->finish();
  if (diverged.empty()) {
    fmt::print(err, "as {} has it: {} messages on {} topics\n", options_.check, check_->messages(),
               check_->topics());
    return true;
  }
  fmt::print(err, "first divergence: {}\n", to_string(diverged.front()));
  for (std::size_t i = 1; i < diverged.size(); ++i)
    fmt::print(err, "then: {}\n", to_string(diverged[i]));
  return false;
}

}  // namespace drydock::replay
