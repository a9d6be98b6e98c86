#include "hil/python/values.hpp"

#include <stdexcept>

namespace drydock::python {

py::object value_of(std::span<const double> row) {
  return py::array_t<double>(static_cast<py::ssize_t>(row.size()), row.data());
}

nlohmann::json json_of(py::handle value) {
  if (value.is_none()) return nullptr;
  if (py::isinstance<py::bool_>(value)) return value.cast<bool>();
  if (py::isinstance<py::int_>(value)) return value.cast<std::int64_t>();
  if (py::isinstance<py::float_>(value)) return value.cast<double>();
  if (py::isinstance<py::str>(value)) return value.cast<std::string>();
  if (py::hasattr(value, "tolist")) return json_of(value.attr("tolist")());
  if (py::isinstance<py::dict>(value)) {
    auto json = nlohmann::json::object();
    for (const auto& [key, item] : value.cast<py::dict>())
      json[py::str(key).cast<std::string>()] = json_of(item);
    return json;
  }
  if (py::isinstance<py::iterable>(value)) {
    auto json = nlohmann::json::array();
    for (const auto item : value) json.push_back(json_of(item));
    return json;
  }
  throw std::invalid_argument("a value of the type " +
                              py::str(py::type::of(value).attr("__name__")).cast<std::string>() +
                              ", allowed: numbers, texts, None, dicts, iterables, arrays");
}

py::object value_of_json(const std::string& text) {
  return py::module_::import("json").attr("loads")(text);
}

}  // namespace drydock::python
