#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <array>
#include <boost/container/static_vector.hpp>
#include <concepts>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

/// The Python module `drydock`: docs/build/python.md.
namespace drydock::python {

namespace py = pybind11;

inline constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

/// A table that grows row by row. Its columns become NumPy arrays that own the memory: nothing is
/// copied. Numbers are float64, int64, uint64 or bool; a value that is not there is NaN. A vector
/// is a row of a two-dimensional column. The elements of a sequence go to columns of their own, and
/// `<name>_offsets` says where those of each row begin.
class Columns {
 public:
  /// Rows have the same columns in the same order; another order is slower.
  void begin_row() { next_ = 0; }

  void field(std::string_view name, double value) { column<double>(name).push_back(value); }
  void field(std::string_view name, std::string_view value) {
    column<std::string>(name).emplace_back(value);
  }
  template <std::integral T>
  void field(std::string_view name, T value) {
    if constexpr (std::is_same_v<T, bool>)
      column<Truth>(name).push_back(value ? 1 : 0);
    else if constexpr (std::is_same_v<T, std::uint64_t>)
      column<std::uint64_t>(name).push_back(value);
    else
      column<std::int64_t>(name).push_back(value);
  }
  template <class T>
  requires std::is_arithmetic_v<T>
  void field(std::string_view name, const std::optional<T>& value) {
    field(name, value ? static_cast<double>(*value) : not_given);
  }
  template <int N>
  void field(std::string_view name, const Eigen::Matrix<double, N, 1>& row) {
    append(name, {row.data(), N});
  }
  template <int N>
  void field(std::string_view name, const std::optional<Eigen::Matrix<double, N, 1>>& row) {
    field(name, row.value_or(Eigen::Matrix<double, N, 1>::Constant(not_given)));
  }
  template <std::size_t N>
  void field(std::string_view name, const std::array<std::optional<double>, N>& row) {
    std::array<double, N> numbers;
    for (std::size_t i = 0; i < N; ++i) numbers[i] = row[i].value_or(not_given);
    append(name, numbers);
  }
  /// Structs with visit_fields.
  template <class Struct, std::size_t N>
  void field(std::string_view name, const boost::container::static_vector<Struct, N>& sequence) {
    end_sequence(name, sequence.size());
    for (const auto& element : sequence)
      visit_fields(element, [&](std::string_view member, const auto& value) {
        field(std::string(name).append(".").append(member), value);
      });
  }

  void append(std::string_view name, std::span<const double> row);
  /// A row has `count` elements of this sequence.
  void end_sequence(std::string_view name, std::size_t count);

  /// Keeps the columns, empty.
  void drop_rows();
  /// The columns by name; the table is empty then. Needs the interpreter's lock, unlike the rest.
  py::dict take();

 private:
  using Truth = std::uint8_t;  ///< the other whole numbers are wide
  using Values =
      std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint64_t>,
                   std::vector<Truth>, std::vector<std::string>>;
  struct Column {
    std::string name;
    std::size_t width;
    Values values;
  };

  template <class T>
  std::vector<T>& column(std::string_view name, std::size_t width = 1) {
    if (next_ >= columns_.size() || columns_[next_].name != name)
      next_ = place_of(name, width, std::vector<T>());
    return std::get<std::vector<T>>(columns_[next_++].values);
  }
  std::size_t place_of(std::string_view name, std::size_t width, Values empty);

  std::vector<Column> columns_;
  std::size_t next_ = 0;
};

/// An array that owns the numbers; rows of `width`.
py::array own(std::vector<double>&& numbers, std::size_t width = 1);

}  // namespace drydock::python
