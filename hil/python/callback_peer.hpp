#pragma once

#include <memory>
#include <string>
#include <vector>

#include "estimators/external/gives.hpp"
#include "estimators/pipeline/peer.hpp"
#include "hil/python/callback.hpp"

namespace drydock::python {

/// An estimator that is a Python function: it gets a Step and gives None, a dict or several dicts,
/// with the keys of docs/build/external-estimator.md.
struct EstimatorCallback {
  std::string name;
  py::function call;
  external::Gives gives = external::Gives::attitude;
  double step_s = 0.05;
};

/// The measurements of a step, as the function sees them.
struct StepObject {
  std::uint64_t number = 0;
  std::int64_t now_ns = 0;  ///< its end
  py::list measurements;
};

class CallbackPeer final : public pipeline::Peer {
 public:
  /// `callback` and `failure` must outlive the peer, which holds nothing of Python: it ends without
  /// the interpreter's lock.
  CallbackPeer(const EstimatorCallback& callback,
               std::shared_ptr<const std::vector<std::string>> devices, Failure& failure)
      : callback_(callback), devices_(std::move(devices)), failure_(failure) {}

  void exchange(const pipeline::Step& step, std::vector<pipeline::OutsideEstimate>& into) override;
  void poll(std::vector<pipeline::OutsideEstimate>&) override {}
  void finish(std::vector<pipeline::OutsideEstimate>&) override {}
  void refuse(const pipeline::OutsideEstimate& estimate, measurement::Stamp now) override;
  const pipeline::PeerAccount& account() const override { return account_; }

 private:
  StepObject object_of(const pipeline::Step& step) const;
  void read(py::handle answer, std::vector<pipeline::OutsideEstimate>& into);

  const EstimatorCallback& callback_;
  std::shared_ptr<const std::vector<std::string>> devices_;
  Failure& failure_;
  pipeline::PeerAccount account_;
};

void add_step_object(py::module_& module);

}  // namespace drydock::python
