#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <string>
#include <utility>

namespace drydock::python {

namespace py = pybind11;

/// The first exception of a run's callbacks. It ends the run, whose caller gets it.
class Failure {
 public:
  bool is() const { return first_ != nullptr; }
  void keep(std::exception_ptr failure) {
    if (!first_) first_ = std::move(failure);
  }
  /// Needs the interpreter's lock.
  void throw_if_any() {
    if (first_) std::rethrow_exception(std::exchange(first_, nullptr));
  }

 private:
  std::exception_ptr first_;
};

/// Does `work` with the interpreter's lock, unless a callback failed before.
template <class Work>
void call_python(Failure& failure, Work&& work) {
  if (failure.is()) return;
  const py::gil_scoped_acquire lock;
  try {
    work();
  } catch (...) {
    failure.keep(std::current_exception());
  }
}

}  // namespace drydock::python
