#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

struct dds_qos;

/// The few parts of Cyclone DDS on which the rest of the bus is built: handles that delete
/// themselves. Public headers of the bus include no DDS header; `dds_entity_t` is an int32.
namespace drydock::bus {

/// Start-up failed. The text says what could not be made and why. Nothing throws after start-up.
class Error : public std::runtime_error {
 public:
  Error(std::string_view what, std::int32_t return_code);
};

/// Owns one DDS entity. Deleting an entity deletes its children, so declare the parent member
/// first: members are destroyed in reverse order, children first.
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
/// XCDR1, no autodispose. A write waits at most `max_blocking_time_ns` for a slow reader.
/// `user_data` is a list of `key=value;`.
Qos make_qos(std::int32_t depth, std::int64_t max_blocking_time_ns, std::string_view user_data);

}  // namespace drydock::bus
