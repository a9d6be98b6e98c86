#include "estimators/frame/local_earth_body.hpp"

namespace drydock::frame {

LocalEarth local_earth(double latitude_rad, double height_m) {
  return local_earth<double>(latitude_rad, height_m);
}

}  // namespace drydock::frame
