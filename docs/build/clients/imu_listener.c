/* Prints the samples of an IMU that drivers publish. docs/build/bus.md says how to build it. */
#include <dds/dds.h>
#include <stdio.h>
#include <stdlib.h>

#include "ros2_messages.h"

int main(int argc, char** argv) {
  const char* topic_name = argc > 1 ? argv[1] : "rt/imu/data";
  const int wanted = argc > 2 ? atoi(argv[2]) : 10, domain = argc > 3 ? atoi(argv[3]) : 0;
  dds_entity_t participant = dds_create_participant((dds_domainid_t)domain, NULL, NULL);
  dds_entity_t topic =
      dds_create_topic(participant, &sensor_msgs_msg_dds__Imu__desc, topic_name, NULL, NULL);
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_entity_t reader = dds_create_reader(participant, topic, qos, NULL);
  dds_delete_qos(qos);
  if (reader < 0) return fprintf(stderr, "no reader: %s\n", dds_strretcode(-reader)), 1;
  for (int heard = 0; heard < wanted;) {
    void* message[1] = {NULL};
    dds_sample_info_t info[1];
    if (dds_take(reader, message, info, 1, 1) <= 0) {
      dds_sleepfor(DDS_MSECS(1));
      continue;
    }
    const sensor_msgs_msg_dds__Imu_* imu = message[0];
    if (info[0].valid_data && ++heard)
      printf("%d.%09u %.6f %.6f %.6f\n", imu->header.stamp.sec, imu->header.stamp.nanosec,
             imu->linear_acceleration.x, imu->linear_acceleration.y, imu->linear_acceleration.z);
    dds_return_loan(reader, message, 1);
  }
  return dds_delete(participant) < 0;
}
