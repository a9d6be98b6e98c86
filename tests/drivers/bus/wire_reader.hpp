#pragma once

#include <dds/dds.h>
#include <dds/ddsi/ddsi_serdata.h>
#include <gtest/gtest.h>

#include "drivers/bus/endpoint.hpp"
#include "tests/drivers/bus/bus_fixture.hpp"
#include "tests/drivers/bus/cdr_reader.hpp"

namespace drydock::bus::test {

/// These names make frame ids as long as in the experiment that gave the expected sizes.
inline std::vector<Device> ros_devices() {
  return {{"dvl", Kind::dvl, Provenance::emulated, Form::complete},
          {"log", Kind::emlog, Provenance::emulated, Form::complete},
          {"gps", Kind::gnss, Provenance::emulated, Form::complete},
          {"imu", Kind::imu, Provenance::emulated, Form::complete},
          {"ctd", Kind::depth, Provenance::emulated, Form::complete},
          {"rudder", Kind::actuator, Provenance::replayed, Form::complete},
          {"compass", Kind::attitude, Provenance::emulated, Form::complete}};
}

/// A publisher of the rig, and the bytes that it writes on one topic.
template <class Message>
class Wire {
 public:
  explicit Wire(const std::string& topic)
      : participant_(test_domain()),
        publisher_(participant_, ros_devices(), {"leveling"}),
        topic_(make_topic<Message>(participant_.handle(), topic)),
        reader_(dds_create_reader(participant_.handle(), topic_.handle(), make_qos(10, 0, "").get(),
                                  nullptr),
                "reader") {
    EXPECT_TRUE(eventually([this] { return publisher_.matched_readers() == 1; }));
  }

  template <class... Arguments>
  CdrReader publish(const Arguments&... arguments) {
    publisher_.publish(arguments...);
    ddsi_serdata* data = nullptr;
    dds_sample_info_t info;
    EXPECT_TRUE(eventually(
        [&] { return dds_takecdr(reader_.handle(), &data, 1, &info, DDS_ANY_STATE) == 1; }));
    std::vector<std::uint8_t> bytes(ddsi_serdata_size(data));
    ddsi_serdata_to_ser(data, 0, bytes.size(), bytes.data());
    ddsi_serdata_unref(data);
    CdrReader cdr(std::move(bytes));
    EXPECT_TRUE(cdr.is_plain_little_endian());
    return cdr;
  }

 private:
  Participant participant_;
  Publisher publisher_;
  Entity topic_, reader_;
};

}  // namespace drydock::bus::test
