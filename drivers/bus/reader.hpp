#pragma once

#include <sys/eventfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "drivers/bus/convert/convert.hpp"
#include "drivers/bus/endpoint.hpp"
#include "drivers/bus/subscriber.hpp"
#include "drivers/bus/topic.hpp"

/// The parts of a subscriber. Only subscriber.cpp, outside_reader.cpp and order_reader.cpp include
/// this file.
namespace drydock::bus {

/// With this depth an estimator that is seconds late still gets every sample.
inline constexpr std::int32_t reader_depth = 2000;

/// An eventfd. DDS threads raise it and the subscriber's thread waits on it.
class Doorbell {
 public:
  Doorbell() : fd_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {
    if (fd_ < 0) throw std::system_error(errno, std::generic_category(), "eventfd");
  }
  ~Doorbell() { ::close(fd_); }
  Doorbell(const Doorbell&) = delete;
  Doorbell& operator=(const Doorbell&) = delete;

  int fd() const { return fd_; }
  void ring() const { ::eventfd_write(fd_, 1); }
  void silence() const {
    eventfd_t rings = 0;
    ::eventfd_read(fd_, &rings);
  }

 private:
  int fd_;
};

/// One topic and its reader. It rings `doorbell` whenever data arrive; `doorbell` must outlive it.
template <class Message>
class Reader {
 public:
  Reader(const Participant& participant, const std::string& topic, Doorbell& doorbell)
      : topic_(make_topic<Message>(participant.handle(), topic)),
        reader_(create(participant, topic_, doorbell), "reader of " + topic) {}
  Reader(Reader&&) noexcept = default;
  ~Reader() {  // returns when no callback runs any more
    if (reader_.handle() > 0) dds_set_listener(reader_.handle(), nullptr);
  }

  /// Calls `f` with every waiting message and its information.
  template <class F>
  void drain(F f) {
    std::array<void*, batch> messages{};
    std::array<dds_sample_info_t, batch> infos;
    for (;;) {
      const auto n = dds_take(reader_.handle(), messages.data(), infos.data(), batch, batch);
      if (n <= 0) return;
      for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i) {
        if (infos[i].valid_data) f(*static_cast<const Message*>(messages[i]), infos[i]);
      }
      dds_return_loan(reader_.handle(), messages.data(), n);
    }
  }

  std::size_t matched() const {
    dds_subscription_matched_status_t status{};
    dds_get_subscription_matched_status(reader_.handle(), &status);
    return status.current_count;
  }

  std::int32_t handle() const { return reader_.handle(); }

 private:
  static constexpr std::size_t batch = 64;

  static dds_entity_t create(const Participant& participant, const Entity& topic,
                             Doorbell& doorbell) {
    const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(
        dds_create_listener(&doorbell), &dds_delete_listener);
    dds_lset_data_available(listener.get(),
                            [](dds_entity_t, void* bell) { static_cast<Doorbell*>(bell)->ring(); });
    return dds_create_reader(participant.handle(), topic.handle(),
                             make_qos(reader_depth, 0, user_data<Message>()).get(), listener.get());
  }

  Entity topic_, reader_;
};

/// What is known of a writer.
struct WriterFacts {
  dds_instance_handle_t handle = 0;
  Provenance provenance{};  ///< that it declared in its USER_DATA
  bool own = false;         ///< of the reader's participant
};

class KnownWriters {
 public:
  explicit KnownWriters(Provenance undeclared) : undeclared_(undeclared) {}

  WriterFacts of(dds_entity_t reader, dds_instance_handle_t writer);

 private:
  static constexpr std::size_t most_known = 64;  ///< writers may come and go without end

  Provenance undeclared_;
  std::vector<WriterFacts> known_;
};

/// A source of samples that a subscriber empties.
class Source {
 public:
  virtual ~Source() = default;
  virtual std::size_t take(Receiver& receiver) = 0;
  virtual std::size_t matched() const = 0;
  std::uint64_t unusable() const { return unusable_; }
  std::uint64_t foreign() const { return foreign_; }

 protected:
  std::uint64_t unusable_ = 0, foreign_ = 0;
};

template <class Message>
class ReaderSource : public Source {
 public:
  ReaderSource(const Participant& participant, const std::string& topic, Doorbell& doorbell)
      : reader_(participant, topic, doorbell) {}
  std::size_t matched() const final { return reader_.matched(); }

 protected:
  Reader<Message> reader_;
};

/// Reads the `Message`s of one device as `Sample`s.
template <class Sample, class Message>
class SampleSource final : public ReaderSource<Message> {
 public:
  SampleSource(const Participant& participant, const Device& device, std::uint16_t index,
               bool own_only, Doorbell& doorbell)
      : ReaderSource<Message>(participant, topic_name(device.name, route<Sample, Message>.suffix),
                              doorbell),
        writers_(device.provenance),
        index_(index),
        own_only_(own_only) {}

  std::size_t take(Receiver& receiver) override {
    std::size_t count = 0;
    this->reader_.drain([&](const Message& message, const dds_sample_info_t& info) {
      const WriterFacts writer = writers_.of(this->reader_.handle(), info.publication_handle);
      if (own_only_ && !writer.own) {
        ++this->foreign_;
        return;
      }
      Measurement measurement{std::in_place_type<Sample>};
      auto& sample = std::get<Sample>(measurement);
      if (!read(sample, message)) {
        ++this->unusable_;
        return;
      }
      sample.origin.received_at = stamp_from_ns(info.source_timestamp);
      sample.origin.provenance = writer.provenance;
      sample.origin.device = index_;
      receiver.receive(measurement);
      ++count;
    });
    return count;
  }

 private:
  KnownWriters writers_;
  std::uint16_t index_;
  bool own_only_;
};

}  // namespace drydock::bus
