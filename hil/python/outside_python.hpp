#pragma once

#include <pybind11/pybind11.h>

#include <optional>

namespace drydock::python {

/// While one lives, its thread works without the interpreter's lock. Signals stay Python's: flags
/// of terminal::InterruptFlag on the thread are set when a handler of the interpreter raises, and
/// in every thread when the interpreter ends, which waits for those that work.
class OutsidePython {
 public:
  OutsidePython();
  ~OutsidePython();
  OutsidePython(const OutsidePython&) = delete;
  OutsidePython& operator=(const OutsidePython&) = delete;

 private:
  std::optional<pybind11::gil_scoped_release> released_;
};

/// Throws what a handler raised while this thread was outside, such as KeyboardInterrupt, and
/// SystemExit where the interpreter ends. Needs the interpreter's lock.
void throw_if_ended();

/// Once, when the module is loaded.
void add_ends(pybind11::module_& module);

}  // namespace drydock::python
