#include <boost/asio/any_io_executor.hpp>

// The compilers name these functions differently, because a type among their parameters depends on
// a constant. Asio's own code is compiled by gcc (drivers/io), so a test that clang compiles finds
// them here under its names.
namespace boost::asio {

using Any = any_io_executor::base_type;

template <>
any_io_executor any_io_executor::require(const execution::blocking_t::never_t& never, int) const {
  return static_cast<const Any&>(*this).require(never);
}

template <>
any_io_executor any_io_executor::prefer(const execution::blocking_t::possibly_t& possibly,
                                        int) const {
  return static_cast<const Any&>(*this).prefer(possibly);
}

template <>
any_io_executor any_io_executor::prefer(const execution::outstanding_work_t::tracked_t& tracked,
                                        int) const {
  return static_cast<const Any&>(*this).prefer(tracked);
}

template <>
any_io_executor any_io_executor::prefer(const execution::outstanding_work_t::untracked_t& untracked,
                                        int) const {
  return static_cast<const Any&>(*this).prefer(untracked);
}

template <>
any_io_executor any_io_executor::prefer(const execution::relationship_t::fork_t& fork, int) const {
  return static_cast<const Any&>(*this).prefer(fork);
}

template <>
any_io_executor any_io_executor::prefer(
    const execution::relationship_t::continuation_t& continuation, int) const {
  return static_cast<const Any&>(*this).prefer(continuation);
}

}  // namespace boost::asio
