#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/wire/described/plan.hpp"
#include "drivers/wire/protocols.hpp"

/// A sensor that a file describes. rig_config/device_description reads it.
namespace drydock::wire::described {

/// What the host says, and the message that answers.
struct Request {
  struct Said {
    std::string field;  ///< of the reply
    double value = 0;   ///< that it must have
  };
  std::string bytes;
  std::string reply;    ///< name of a message; empty: none is awaited
  std::string refusal;  ///< name of the message that says no; empty: it cannot be refused
  std::vector<Said> says;
};

struct FramePlan;

struct Description {
  std::string name;          ///< of the file, as a rig names it: `valeport-vat.toml`
  std::string title;         ///< the sensor in words
  Protocol facts;            ///< its name is `name`
  std::optional<Kind> kind;  ///< empty: it measures nothing, only `drydock decode` reads it
  Plan plan;
  std::shared_ptr<const FramePlan> frames;  ///< of a DBC file; null: it travels as bytes
  std::string dbc_file;        ///< path of the DBC file; empty: it is part of the program
  std::vector<Request> start;  ///< when the link opens, in this order
  std::vector<Request> poll;   ///< at the rate of the sensor, in this order
  std::chrono::nanoseconds reply_within = std::chrono::seconds{1};
};

/// It must not move: the facts refer to the name.
using DescriptionPtr = std::shared_ptr<const Description>;

}  // namespace drydock::wire::described
