/* Orders one joint of the emulated vehicle ten times a second. docs/world/steering.md says how to
 * build it. */
#include <dds/dds.h>
#include <stdio.h>
#include <stdlib.h>

#include "ros2_messages.h"

/* JOINT, position|velocity|effort, VALUE, seconds, domain */
int main(int argc, char** argv) {
  if (argc < 4)
    return fprintf(stderr, "usage: %s JOINT position|velocity|effort VALUE\n", argv[0]), 2;
  double value = atof(argv[3]);
  const int times = 10 * (argc > 4 ? atoi(argv[4]) : 10), domain = argc > 5 ? atoi(argv[5]) : 0;
  dds_entity_t participant = dds_create_participant((dds_domainid_t)domain, NULL, NULL);
  dds_entity_t topic = dds_create_topic(participant, &sensor_msgs_msg_dds__JointState__desc,
                                        "rt/command/joints", NULL, NULL);
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_entity_t writer = dds_create_writer(participant, topic, qos, NULL);
  dds_delete_qos(qos);
  if (writer < 0) return fprintf(stderr, "no writer: %s\n", dds_strretcode(-writer)), 1;
  sensor_msgs_msg_dds__JointState_ order = {0};
  order.header.frame_id = "";
  order.name._buffer = &argv[1];
  order.name._length = 1;
  dds_sequence_double* list = argv[2][0] == 'p'   ? &order.position
                              : argv[2][0] == 'v' ? &order.velocity
                                                  : &order.effort;
  list->_buffer = &value;
  list->_length = 1;
  for (int i = 0; i < times; ++i) {
    if (dds_write(writer, &order) < 0) return 1;
    dds_sleepfor(DDS_MSECS(100));
  }
  return dds_delete(participant) < 0;
}
