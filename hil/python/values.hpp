#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <array>
#include <boost/container/static_vector.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "hil/python/columns.hpp"

namespace drydock::python {

/// The Python value of a field: a number, None for a value that is not there, an array, a list of
/// dicts.
py::object value_of(std::span<const double> row);
inline py::object value_of(double value) { return py::float_(value); }
inline py::object value_of(bool value) { return py::bool_(value); }
inline py::object value_of(std::string_view value) { return py::str(value.data(), value.size()); }
template <std::integral T>
py::object value_of(T value) {
  return py::int_(value);
}
template <int N>
py::object value_of(const Eigen::Matrix<double, N, 1>& row) {
  return value_of(std::span<const double>(row.data(), N));
}
template <std::size_t N>
py::object value_of(const std::array<std::optional<double>, N>& row) {
  std::array<double, N> numbers;
  for (std::size_t i = 0; i < N; ++i) numbers[i] = row[i].value_or(not_given);
  return value_of(std::span<const double>(numbers));
}
template <class T>
py::object value_of(const std::optional<T>& value) {
  return value ? value_of(*value) : py::object(py::none());
}
template <class Struct>
py::dict dict_of(const Struct& fields);
template <class Struct, std::size_t N>
py::object value_of(const boost::container::static_vector<Struct, N>& sequence) {
  py::list list;
  for (const auto& element : sequence) list.append(dict_of(element));
  return list;
}

/// The fields of a struct with visit_fields.
template <class Struct>
py::dict dict_of(const Struct& fields) {
  py::dict dict;
  visit_fields(fields, [&](std::string_view name, const auto& value) {
    dict[py::str(name.data(), name.size())] = value_of(value);
  });
  return dict;
}

/// Numbers, texts, None, dicts, iterables, and what has tolist(), such as NumPy's. Throws
/// std::invalid_argument for anything else.
nlohmann::json json_of(py::handle value);

/// The Python value of a JSON text.
py::object value_of_json(const std::string& text);

}  // namespace drydock::python
