#include "drivers/bus/outside_reader.hpp"

#include <poll.h>

#include "drivers/bus/convert/convert_outside.hpp"
#include "drivers/bus/reader.hpp"

namespace drydock::bus {

struct OutsideReader::Source {
  virtual ~Source() = default;
  virtual void take(const std::function<void(const Heard&)>& to) = 0;
  virtual std::size_t matched() const = 0;
  virtual int doorbell() const = 0;
  std::uint64_t unusable = 0;
};

namespace {

using Heard = OutsideReader::Heard;

std::string dds_name(const std::string& ros_name) { return "rt" + ros_name; }

template <class Message, class Base>
class OutsideSource final : public Base {
 public:
  OutsideSource(const Participant& participant, const std::string& topic)
      : reader_(participant, dds_name(topic), doorbell_) {}

  void take(const std::function<void(const Heard&)>& to) override {
    doorbell_.silence();
    reader_.drain([&](const Message& message, const dds_sample_info_t& info) {
      Heard heard;
      heard.sent_at = measurement::stamp_from_ns(info.source_timestamp);
      read(heard.values, message) ? to(heard) : static_cast<void>(++this->unusable);
    });
  }
  std::size_t matched() const override { return reader_.matched(); }
  int doorbell() const override { return doorbell_.fd(); }

 private:
  Doorbell doorbell_;
  Reader<Message> reader_;
};

template <class Base>
std::unique_ptr<Base> outside_source(const Participant& participant, const std::string& topic,
                                     OutsideType type) {
  switch (type) {
    case OutsideType::imu:
      return std::make_unique<OutsideSource<ImuMessage, Base>>(participant, topic);
    case OutsideType::odometry:
      return std::make_unique<OutsideSource<OdometryMessage, Base>>(participant, topic);
    case OutsideType::pose:
      return std::make_unique<OutsideSource<PoseMessage, Base>>(participant, topic);
    case OutsideType::twist:
      return std::make_unique<OutsideSource<TwistMessage, Base>>(participant, topic);
    case OutsideType::fix:
      return std::make_unique<OutsideSource<NavSatFixMessage, Base>>(participant, topic);
  }
  return nullptr;
}

}  // namespace

OutsideReader::OutsideReader(const Participant& participant, const std::string& topic,
                             OutsideType type)
    : source_(outside_source<Source>(participant, topic, type)) {}
OutsideReader::~OutsideReader() = default;

void OutsideReader::take(const std::function<void(const Heard&)>& to) { source_->take(to); }
void OutsideReader::wait(std::chrono::nanoseconds longest) const {
  pollfd rung{source_->doorbell(), POLLIN, 0};
  const auto seconds = std::chrono::floor<std::chrono::seconds>(longest);
  const timespec limit{seconds.count(), (longest - seconds).count()};
  ::ppoll(&rung, 1, &limit, nullptr);
}
std::size_t OutsideReader::matched_writers() const { return source_->matched(); }
std::uint64_t OutsideReader::unusable() const { return source_->unusable; }

}  // namespace drydock::bus
