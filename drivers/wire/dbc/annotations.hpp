#pragma once

#include <optional>
#include <unordered_map>
#include <vector>

#include "drivers/wire/dbc/attributes.hpp"
#include "drivers/wire/dbc/database.hpp"
#include "drivers/wire/dbc/multiplexing.hpp"
#include "drivers/wire/dbc/remarks.hpp"
#include "drivers/wire/dbc/scanner.hpp"

namespace drydock::wire::dbc {

/// What was read of a file so far. Places of messages and signals are kept until multiplexing is
/// resolved at the end.
struct Contents {
  Database& database;
  Remarks remarks;
  Attributes attributes{};
  std::unordered_map<std::uint32_t, std::size_t> places{};  ///< by the identifier as written
  std::vector<std::vector<Choice>> choices{};               ///< beside the messages' signals
};

std::uint32_t read_identifier(Scanner& in);
void add_sender(Message& m, std::string_view name);

/// Thrown at a reference to a message that may still come.
struct TooEarly {};

/// Reads the statements that say more of nodes, messages and signals.
class Annotations {
 public:
  Annotations(Scanner& in, Contents& contents) : in_(in), contents_(contents) {}

  void more_senders();        ///< BO_TX_BU_
  void comment();             ///< CM_
  void attribute();           ///< BA_
  void labels();              ///< VAL_
  void value_type();          ///< SIG_VALTYPE_
  void multiplexed_values();  ///< SG_MUL_VAL_

  /// From now on a reference to an unknown message is doubtful, and no longer too early.
  void all_messages_are_read() { complete_ = true; }

  /// Takes the ';'. A warning where the next statement or the end of the file comes instead.
  void end_statement();

 private:
  struct Found {
    std::size_t message = 0;
    Signal* signal = nullptr;
    Choice* choice = nullptr;
  };

  std::optional<std::size_t> referred_message();
  std::optional<Found> referred_signal();
  std::optional<Found> referred_signal(std::optional<std::size_t> message);
  std::string* comment_of_signal();
  Node* node(std::string_view name);
  std::string_view object_word();

  Scanner& in_;
  Contents& contents_;
  bool complete_ = false;
};

}  // namespace drydock::wire::dbc
