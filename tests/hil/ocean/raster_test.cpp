#include "hil/ocean/raster.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "hil/ocean/bed.hpp"

namespace drydock::ocean {
namespace raster_test {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Like the example in ESRI's own description: upper and lower case, corner of the cell.
const std::string small =
    "NCOLS 3\nNROWS 2\nXLLCORNER 100\nYLLCORNER -20\nCELLSIZE 10\nNODATA_VALUE -9999\n"
    "1 2 3\n4 5 6\n";

std::string error_of(std::string text, const std::string& from = "", const std::string& to = "") {
  if (!from.empty()) text.replace(text.find(from), from.size(), to);
  const auto raster = read_raster(text);
  return raster ? "none" : fmt::format("{}: {}", raster.error().line, raster.error().what);
}

TEST(Raster, TheFirstRowIsTheNorthernmostAndPointsAreCellCentres) {
  const Raster raster = read_raster(small).value();
  EXPECT_EQ(raster.columns, 3);
  EXPECT_EQ(raster.rows, 2);
  EXPECT_EQ(raster.x, 105);
  EXPECT_EQ(raster.y, -15);
  EXPECT_EQ(raster.at(0, 0), 4);  // south-west
  EXPECT_EQ(raster.at(1, 2), 3);  // north-east
}

TEST(Raster, WhatIsNoRasterIsRefusedWithItsLine) {
  EXPECT_EQ(error_of(""), "1: the file ends before its values");
  EXPECT_EQ(error_of(small, "NROWS 2\n", ""), "5: the header has no nrows");
  EXPECT_EQ(error_of(small, "NROWS 2", "NROWS 2.5"),
            "6: ncols and nrows must be whole numbers of 1 or more, at most 1e8 points in all");
  EXPECT_EQ(error_of(small, "XLLCORNER 100\n", ""),
            "5: the header needs either xllcorner or xllcenter");
  EXPECT_EQ(error_of(small, "CELLSIZE 10", "CELLSIZE 0"), "6: cellsize must be at least 1e-9");
  EXPECT_EQ(error_of(small, "NCOLS", "NCOLUMNS"),
            "1: unknown header word 'NCOLUMNS', allowed: ncols, nrows, xllcorner, xllcenter, "
            "yllcorner, yllcenter, cellsize, nodata_value");
  EXPECT_EQ(error_of(small, "4 5 6", "4 5"), "9: the file ends after 5 of 6 values");
  EXPECT_EQ(error_of(small, "4 5 6", "4 5 6 7"), "8: there are more than 6 values");
  EXPECT_EQ(error_of(small, "5", "-9999"),
            "8: a point has no value; fill the gaps of the raster first");
  EXPECT_EQ(error_of(small, "5", "nan"), "8: 'nan' is no value, -12000 to 12000 m");
}

RC_GTEST_PROP(Raster, AnyTextIsRefusedOrHasAsManyValuesAsItsHeaderSays, (std::string text)) {
  const auto raster = read_raster(text);
  if (raster.has_value()) {
    RC_ASSERT(raster->values.size() == raster->rows * raster->columns);
  } else {
    RC_ASSERT(raster.error().line >= 1);
  }
}

RC_GTEST_PROP(Raster, WhatIsWrittenIsRead, ()) {
  const int columns = *rc::gen::inRange(1, 8), rows = *rc::gen::inRange(1, 8);
  std::string text = fmt::format(
      "ncols {}\r\nnrows {}\r\nxllcenter 5\r\nyllcenter 7\r\ncellsize 0.25\r\n", columns, rows);
  std::vector<int> values;
  for (int i = 0; i < columns * rows; ++i) {
    values.push_back(*rc::gen::inRange(-5000, 5000));
    text += fmt::format("{}{}", values.back() * 0.5, i % 3 ? " " : "\r\n");
  }
  const Raster raster = read_raster(text).value();
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t row = raster.rows - 1 - i / raster.columns;
    RC_ASSERT(raster.at(row, i % raster.columns) == values[i] * 0.5);
  }
}

/// depth(north, east) at whole multiples of 10 m, 21 x 21 points around the origin.
template <class Depth>
RasterBed sampled(Depth depth) {
  Raster raster{21, 21, -100, -100, 10, {}};
  for (int north = -100; north <= 100; north += 10)
    for (int east = -100; east <= 100; east += 10)
      raster.values.push_back(static_cast<float>(depth(north, east)));
  return {std::move(raster), {-100, -100}, {10, 10}};
}

TEST(RasterBed, IsBilinearBetweenPointsAndKeepsItsEdgesDepthBeyond) {
  const auto depth = [](double n, double e) { return 50 + n / 10 + e / 20 + n * e / 1000; };
  const RasterBed bed = sampled(depth);
  // A bilinear function over all cells is reproduced exactly, also between the points.
  EXPECT_NEAR(bed.depth_at({3.7, -44.1}), depth(3.7, -44.1), 1e-5);
  EXPECT_NEAR(bed.depth_at({500, -44.1}), depth(100, -44.1), 1e-5);
  EXPECT_NEAR(bed.depth_at({500, 700}), depth(100, 100), 1e-5);
  EXPECT_NEAR(bed.depth_at({3.7, -700}), depth(3.7, -100), 1e-5);
}

RC_GTEST_PROP(RasterBed, OfASampledPlaneGivesThePlanesRanges, ()) {
  const double gn = *rc::gen::inRange(-50, 50) / 100.0, ge = *rc::gen::inRange(-50, 50) / 100.0;
  const PlaneBed plane{100, {gn, ge}};
  const RasterBed bed = sampled([&](double n, double e) { return plane.depth_at({n, e}); });
  const double north = *rc::gen::inRange(-40, 40), east = *rc::gen::inRange(-40, 40);
  const double tilt = *rc::gen::inRange(0, 45) * M_PI / 180, way = *rc::gen::inRange(0, 360);
  const Ray ray{{north, east, 50},
                {std::sin(tilt) * std::cos(way), std::sin(tilt) * std::sin(way), std::cos(tilt)}};
  const auto expected = plane.range(ray, 200), found = bed.range(ray, 200);
  RC_PRE(expected.has_value());
  const Vector3d met = ray.from + *expected * ray.along;
  RC_PRE(met.head<2>().cwiseAbs().maxCoeff() < 100);
  RC_ASSERT(found.has_value());
  RC_ASSERT(std::abs(*found - *expected) < 1e-4);
}

RC_GTEST_PROP(RasterBed, ARayEndsOnTheBedAndNeverPassesThroughIt, ()) {
  const auto depths = *rc::gen::container<std::vector<int>>(441, rc::gen::inRange(20, 60));
  std::size_t i = 0;
  const RasterBed bed = sampled([&](double, double) { return depths[i++]; });
  const double way = *rc::gen::inRange(0, 628) / 100.0, tilt = *rc::gen::inRange(0, 157) / 100.0;
  const Ray ray{{*rc::gen::inRange(-99, 99) * 1.0, *rc::gen::inRange(-99, 99) * 1.0, 10},
                {std::sin(tilt) * std::cos(way), std::sin(tilt) * std::sin(way), std::cos(tilt)}};
  const double longest = 150, end = bed.range(ray, longest).value_or(longest);
  const auto above = [&](double s) {
    const Vector3d p = ray.from + s * ray.along;
    return bed.depth_at(p.head<2>()) - p.z();
  };
  for (double s = 0; s < end - 1e-6; s += 0.05) RC_ASSERT(above(s) > -1e-9);
  if (end < longest) RC_ASSERT(std::abs(above(end)) < 1e-9);
}

TEST(RasterBed, ARayThatBeginsInTheBedOrLooksUpMeetsNone) {
  const RasterBed bed = sampled([](double, double) { return 50; });
  EXPECT_FALSE(bed.range({{0, 0, 60}, {0, 0, 1}}, 100));
  EXPECT_FALSE(bed.range({{0, 0, 40}, {0, 0, -1}}, 100));
  EXPECT_FALSE(bed.range({{0, 0, 40}, {0, 0, 1}}, 9.9));
  EXPECT_NEAR(*bed.range({{0, 0, 40}, {0, 0, 1}}, 10.1), 10, 1e-12);
}

}  // namespace raster_test
}  // namespace drydock::ocean
