#include "estimators/external/client_peer.hpp"

#include <utility>

namespace drydock::external {
namespace {

std::vector<std::string> names_of(const Hello& hello) {
  std::vector<std::string> names;
  for (const auto& device : hello.devices) names.push_back(device.name);
  return names;
}

ProgramOptions program_of(ClientOptions options) {
  return {.command = std::move(options.command),
          .folder = std::move(options.folder),
          .name = std::move(options.hello.estimator),
          .lockstep = options.hello.lockstep,
          .answer_within = options.answer_within,
          .say = std::move(options.say)};
}

}  // namespace

ClientPeer::ClientPeer(const ClientOptions& options)
    : gives_(options.hello.gives),
      names_(names_of(options.hello)),
      lines_(names_),
      dialogue_(
          program_of(options), line_of(options.hello),
          [this](std::string_view line) { return read(line); },
          [this] {
            into_->insert(into_->end(), answer_.estimates.begin(), answer_.estimates.end());
          }) {}

Heard ClientPeer::read(std::string_view line) {
  answer_ = read_answer(line, gives_);
  return {answer_.step, answer_.flaw, answer_.what};
}

void ClientPeer::exchange(const pipeline::Step& step, Estimates& into) {
  into_ = &into;
  if (dialogue_.begin_step(step.now)) dialogue_.send(step.number, lines_.line_of(step));
}

void ClientPeer::poll(Estimates& into) {
  into_ = &into;
  dialogue_.poll();
}

void ClientPeer::finish(Estimates& into) {
  into_ = &into;
  dialogue_.finish();
}

void ClientPeer::refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) {
  dialogue_.complaints().add(dialogue_.account().out_of_time,
                             out_of_time(measurement::seconds(pipeline::valid_at(estimate) - now)));
}

}  // namespace drydock::external
