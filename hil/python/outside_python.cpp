#include "hil/python/outside_python.hpp"

#include <atomic>
#include <chrono>
#include <exception>
#include <thread>
#include <utility>

#include "drivers/terminal/interrupt_flag.hpp"

namespace drydock::python {
namespace {

namespace py = pybind11;
using Clock = std::chrono::steady_clock;

std::atomic<int> outside = 0;  // threads
std::atomic<bool> interpreter_ends = false;
thread_local std::exception_ptr raised;
thread_local Clock::time_point asked_at;

/// Handlers of Python run in its main thread, between two of its instructions: of a thread that
/// works elsewhere, only when it asks.
bool is_to_end() {
  constexpr std::chrono::milliseconds every{20};
  if (raised || interpreter_ends) return true;
  if (PyGILState_GetThisThreadState() == nullptr) return false;  // a helper of the work
  if (const auto now = Clock::now(); now - asked_at >= every)
    asked_at = now;
  else
    return false;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return false;
  raised = std::make_exception_ptr(py::error_already_set());
  return true;
}

/// A thread that comes back after the interpreter's end is torn out of C++, which aborts. A
/// callback that does not return cannot be waited for.
void await_those_outside() {
  constexpr std::chrono::seconds longest{2};
  interpreter_ends = true;
  const py::gil_scoped_release others_run;
  for (const auto until = Clock::now() + longest; outside > 0 && Clock::now() < until;)
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
}

}  // namespace

OutsidePython::OutsidePython() {
  raised = nullptr;
  ++outside;
  released_.emplace();
}

OutsidePython::~OutsidePython() {
  released_.reset();
  --outside;
}

void throw_if_ended() {
  if (raised) std::rethrow_exception(std::exchange(raised, nullptr));
  if (!interpreter_ends) return;
  PyErr_SetNone(PyExc_SystemExit);
  throw py::error_already_set();
}

void add_ends(py::module_&) {
  terminal::leave_signals_to(&is_to_end);
  py::module_::import("atexit").attr("register")(py::cpp_function(&await_those_outside));
}

}  // namespace drydock::python
