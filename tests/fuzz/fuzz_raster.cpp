#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "hil/ocean/bed.hpp"

using namespace drydock;

/// Any text is refused with a line or gives a bed. The bed has a depth everywhere, and beams end on
/// it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  auto raster = ocean::read_raster({reinterpret_cast<const char*>(data), size});
  if (!raster) {
    if (raster.error().line < 1) std::abort();
    return 0;
  }
  if (raster->values.size() != raster->rows * raster->columns) std::abort();
  const double middle = static_cast<double>(raster->columns) / 2;
  const ocean::RasterBed bed(std::move(*raster), {0, 0}, {1, 1});
  for (const double north : {-3.0, 0.25, middle, 1e9}) {
    const double depth = bed.depth_at({north, middle});
    if (!std::isfinite(depth)) std::abort();
    const ocean::Ray ray{{north, middle, depth - 20}, {0.3, -0.4, std::sqrt(0.75)}};
    const auto range = bed.range(ray, 200);
    if (!range) continue;
    const Eigen::Vector3d end = ray.from + *range * ray.along;
    if (std::abs(bed.depth_at(end.head<2>()) - end.z()) > 1e-3) std::abort();
  }
  return 0;
}
