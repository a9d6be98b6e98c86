#pragma once

#include <boost/system/result.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// ESRI ASCII grids (.asc), the plain-text raster that every GIS writes. The header has `ncols`,
/// `nrows`, `xllcorner` or `xllcenter`, `yllcorner` or `yllcenter`, `cellsize` and, if points may
/// be missing, `nodata_value`. The values follow, northernmost row first.
namespace drydock::ocean {

struct Raster {
  std::size_t columns = 0, rows = 0;
  double x = 0, y = 0;  ///< the south-western point, which is the centre of its cell
  double spacing = 0;
  std::vector<float> values;  ///< southernmost row first

  double at(std::size_t row, std::size_t column) const { return values[row * columns + column]; }
};

struct RasterError {
  int line = 0;      ///< from 1; 0 for a file that cannot be read
  std::string what;  ///< what is wrong and what is allowed
};

/// A sea bed whose file is no raster. what() is `file:line: what is wrong, what is allowed`.
class BadRaster : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Called by result::value() if there is no raster; throws std::invalid_argument.
[[noreturn]] void throw_exception_from_error(const RasterError& error,
                                             const boost::source_location& where);

/// The whole raster, or its first error. A point without a value is an error: no value is guessed.
boost::system::result<Raster, RasterError> read_raster(std::string_view text);
boost::system::result<Raster, RasterError> read_raster_file(const std::string& path);

}  // namespace drydock::ocean
