#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

struct dds_qos;

/// The little of Cyclone DDS that the rest of the bus is built on: handles that delete themselves.
/// Public headers of the bus show no DDS header; `dds_entity_t` is an int32.
namespace drydock::bus {

/// Start-up failed; the text says what could not be made and why. Nothing throws once running.
class Error : public std::runtime_error {
 public:
  Error(std::string_view what, std::int32_t return_code);
};

/// Owner of one DDS entity. Deleting an entity deletes its children, so members are declared
/// parent first and destroyed child first.
class Entity {
 public:
  Entity() = default;
  Entity(std::int32_t handle_or_error, std::string_view what);  ///< throws Error on an error code
  Entity(Entity&& other) noexcept : handle_(std::exchange(other.handle_, 0)) {}
  Entity& operator=(Entity&& other) noexcept {
    std::swap(handle_, other.handle_);
    return *this;
  }
  ~Entity();

  std::int32_t handle() const { return handle_; }

 private:
  std::int32_t handle_ = 0;
};

struct QosDelete {
  void operator()(dds_qos* qos) const;
};
using Qos = std::unique_ptr<dds_qos, QosDelete>;

/// Quality of service of a ROS 2 publisher or subscription: reliable, volatile, keep last `depth`,
/// XCDR1, no autodispose. `max_blocking_time_ns` is how long a write may wait for a slow reader.
/// `user_data` is a list of `key=value;`.
Qos make_qos(std::int32_t depth, std::int64_t max_blocking_time_ns, std::string_view user_data);

}  // namespace drydock::bus
