#include "drivers/bus/entity.hpp"

#include <dds/dds.h>

#include <string>

namespace drydock::bus {

Error::Error(std::string_view what, std::int32_t return_code)
    : std::runtime_error("DDS: " + std::string(what) + ": " + dds_strretcode(-return_code)) {}

Entity::Entity(std::int32_t handle_or_error, std::string_view what) : handle_(handle_or_error) {
  if (handle_or_error < 0) throw Error(what, handle_or_error);
}

Entity::~Entity() {
  if (handle_ > 0) dds_delete(handle_);
}

void QosDelete::operator()(dds_qos* qos) const { dds_delete_qos(qos); }

Qos make_qos(std::int32_t depth, std::int64_t max_blocking_time_ns, std::string_view user_data) {
  Qos qos(dds_create_qos());
  dds_qset_reliability(qos.get(), DDS_RELIABILITY_RELIABLE, max_blocking_time_ns);
  dds_qset_durability(qos.get(), DDS_DURABILITY_VOLATILE);
  dds_qset_history(qos.get(), DDS_HISTORY_KEEP_LAST, depth);
  dds_qset_writer_data_lifecycle(qos.get(), false);
  const dds_data_representation_id_t xcdr1 = DDS_DATA_REPRESENTATION_XCDR1;
  dds_qset_data_representation(qos.get(), 1, &xcdr1);
  if (!user_data.empty()) dds_qset_userdata(qos.get(), user_data.data(), user_data.size());
  return qos;
}

}  // namespace drydock::bus
