/* An estimator on the bus in step with virtual time: roll and pitch by low-passed gravity. A step
 * ends with /clock; its answer is the message with that stamp. docs/build/external-estimator.md */
#include <dds/dds.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "ros2_messages.h"

static dds_entity_t participant, imus, clocks, estimates;
static double gravity[3]; /* forward, left, up */

static void open_topics(const char* imu_topic, const char* estimate_topic) {
  dds_qos_t* qos = dds_create_qos();
  dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
  dds_qset_history(qos, DDS_HISTORY_KEEP_LAST, 2000);
  const dds_topic_descriptor_t* imu = &sensor_msgs_msg_dds__Imu__desc;
  dds_entity_t in = dds_create_topic(participant, imu, imu_topic, NULL, NULL);
  dds_entity_t out = dds_create_topic(participant, imu, estimate_topic, NULL, NULL);
  dds_entity_t time =
      dds_create_topic(participant, &rosgraph_msgs_msg_dds__Clock__desc, "rt/clock", NULL, NULL);
  imus = dds_create_reader(participant, in, qos, NULL);
  estimates = dds_create_writer(participant, out, qos, NULL);
  clocks = dds_create_reader(participant, time, qos, NULL); /* the last one: all else is open */
  dds_delete_qos(qos);
}

/* Whether there was a message; `into` is valid until the next one. */
static int take(dds_entity_t reader, void** into) {
  dds_sample_info_t info;
  if (*into) dds_return_loan(reader, into, 1);
  *into = NULL;
  return dds_take(reader, into, &info, 1, 1) > 0;
}

static void answer(const builtin_interfaces_msg_dds__Time_* stamp) {
  const double *g = gravity, roll = atan2(g[1], g[2]), pitch = atan2(-g[0], hypot(g[1], g[2]));
  sensor_msgs_msg_dds__Imu_ estimate = {0};
  estimate.header.stamp = *stamp;
  estimate.header.frame_id = "base_link";
  estimate.orientation.x = sin(roll / 2) * cos(pitch / 2);
  estimate.orientation.y = cos(roll / 2) * sin(pitch / 2);
  estimate.orientation.z = -sin(roll / 2) * sin(pitch / 2);
  estimate.orientation.w = cos(roll / 2) * cos(pitch / 2);
  estimate.orientation_covariance[0] = estimate.orientation_covariance[4] = 1e-4;
  estimate.orientation_covariance[8] = 1e6; /* heading is not known */
  dds_write(estimates, &estimate);
}

/* IMU topic, estimate topic, domain */
int main(int argc, char** argv) {
  participant = dds_create_participant((dds_domainid_t)(argc > 3 ? atoi(argv[3]) : 0), NULL, NULL);
  open_topics(argc > 1 ? argv[1] : "rt/imu/data", argc > 2 ? argv[2] : "rt/my/attitude");
  if (clocks < 0) return fprintf(stderr, "no reader: %s\n", dds_strretcode(-clocks)), 1;
  void *imu = NULL, *tick = NULL;
  for (;;) {
    if (!take(clocks, &tick)) {
      dds_sleepfor(DDS_USECS(100));
      continue;
    }
    while (take(imus, &imu)) { /* all of this step are here before its /clock */
      const geometry_msgs_msg_dds__Vector3_* f =
          &((sensor_msgs_msg_dds__Imu_*)imu)->linear_acceleration;
      gravity[0] += 0.01 * (f->x - gravity[0]);
      gravity[1] += 0.01 * (f->y - gravity[1]);
      gravity[2] += 0.01 * (f->z - gravity[2]);
    }
    answer(&((rosgraph_msgs_msg_dds__Clock_*)tick)->clock);
  }
}
