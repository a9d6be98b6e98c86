#pragma once

#include <array>

#include "drivers/link/opening.hpp"

namespace drydock::link {

/// The rates with a command of slcan adapters, the most usual ones of vehicles first.
constexpr std::array<unsigned, 9> slcan_search_order{250'000, 500'000, 125'000, 1'000'000, 100'000,
                                                     50'000,  20'000,  10'000,  800'000};

/// How an adapter takes part in the bus: a listening one sends no acknowledgement and no error
/// flag.
struct SlcanChannel {
  unsigned bit_rate = 250'000;
  bool listens = false;
  /// Listens at each rate of the search order for 2 s until a frame comes, and stays there.
  bool searches = false;
};

/// The computer's end of an slcan adapter on any byte link. The first read or write opens the
/// channel: an empty line (it ends an incomplete one), C, S with the rate, O or L; each waits for
/// the answer to the one before. close() sends C. A frame gets its stamp when its bytes are read:
/// the adapter's own stamps have only milliseconds and an epoch of their own.
std::unique_ptr<FrameLink> make_slcan(const asio::any_io_executor& executor,
                                      std::unique_ptr<ByteLink> line, SlcanChannel channel);

/// `slcan:` URIs. The device side is an emulated adapter; its bus has no other members.
OpenedFrames open_slcan(const asio::any_io_executor& executor, const Uri& uri, Side side);

}  // namespace drydock::link
