#include "hil/python/columns.hpp"

#include <algorithm>
#include <utility>

namespace drydock::python {
namespace {

template <class T>
py::array owning(std::vector<T>&& values, std::size_t width, const py::dtype& type) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* memory) { delete static_cast<std::vector<T>*>(memory); });
  const auto rows = static_cast<py::ssize_t>(kept->size() / width);
  std::vector<py::ssize_t> shape{rows};
  if (width > 1) shape.push_back(static_cast<py::ssize_t>(width));
  return {type, shape, kept->data(), owner};
}

py::array array_of(std::vector<std::string>&& texts, std::size_t) {
  py::list list;
  for (const auto& text : texts)
    list.append(py::reinterpret_steal<py::str>(
        PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()), "replace")));
  return py::module_::import("numpy").attr("array")(list, py::arg("dtype") = "str");
}
py::array array_of(std::vector<std::uint8_t>&& truths, std::size_t width) {
  return owning(std::move(truths), width, py::dtype::of<bool>());
}
template <class T>
py::array array_of(std::vector<T>&& numbers, std::size_t width) {
  return owning(std::move(numbers), width, py::dtype::of<T>());
}

}  // namespace

py::array own(std::vector<double>&& numbers, std::size_t width) {
  return array_of(std::move(numbers), width);
}

std::size_t Columns::place_of(std::string_view name, std::size_t width, Values empty) {
  const auto found = std::ranges::find(columns_, name, &Column::name);
  if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
  columns_.push_back({std::string(name), width, std::move(empty)});
  return columns_.size() - 1;
}

void Columns::append(std::string_view name, std::span<const double> row) {
  auto& values = column<double>(name, row.size());
  values.insert(values.end(), row.begin(), row.end());
}

void Columns::end_sequence(std::string_view name, std::size_t count) {
  auto& offsets = column<std::int64_t>(std::string(name) + "_offsets");
  if (offsets.empty()) offsets.push_back(0);
  offsets.push_back(offsets.back() + static_cast<std::int64_t>(count));
}

void Columns::drop_rows() {
  for (auto& column : columns_) std::visit([](auto& values) { values.clear(); }, column.values);
  next_ = 0;
}

py::dict Columns::take() {
  py::dict arrays;
  for (auto& column : std::exchange(columns_, {}))
    arrays[py::str(column.name)] = std::visit(
        [&](auto& values) { return array_of(std::move(values), column.width); }, column.values);
  next_ = 0;
  return arrays;
}

}  // namespace drydock::python
