#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "drivers/wire/described/codec.hpp"
#include "drivers/wire/registry.hpp"
#include "rig_config/device_description/load_description.hpp"

/// Decoding speed. It repeats the golden bytes, in pieces as from a link.
namespace drydock::wire {
namespace {

using Buffer = std::vector<std::uint8_t>;

constexpr std::size_t stream_size = 4 << 20, piece = 4096;

void append_file(Buffer& stream, const char* name) {
  const auto path = std::filesystem::path{DRYDOCK_SOURCE_DIR} / "fixtures" / name;
  std::ifstream file{path, std::ios::binary};
  stream.insert(stream.end(), std::istreambuf_iterator<char>{file}, {});
}

Buffer repeated(const std::vector<const char*>& files) {
  Buffer stream;
  do {
    for (const char* file : files) append_file(stream, file);
  } while (!stream.empty() && stream.size() < stream_size);
  return stream;
}

template <class P>
void scan_and_decode(benchmark::State& state, std::vector<const char*> files) {
  const Buffer stream = repeated(files);
  const auto framer = std::make_unique<Framer<P::max_frame>>();
  std::size_t messages = 0;
  for (auto _ : state) {
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      const Bytes bytes = Bytes{stream}.subspan(at, std::min(piece, stream.size() - at));
      framer->feed(bytes, P::scan, [&](Bytes frame, std::size_t) {
        const auto message = P::decode(frame);
        benchmark::DoNotOptimize(&message);
        messages += message.has_value();
      });
    }
  }
  const auto rounds = static_cast<std::int64_t>(state.iterations());
  state.SetBytesProcessed(rounds * static_cast<std::int64_t>(stream.size()));
  state.SetItemsProcessed(static_cast<std::int64_t>(messages));
}

void nmea0183(benchmark::State& state) {
  scan_and_decode<Nmea0183>(state, {"nmea0183/golden.nmea"});
}
BENCHMARK(nmea0183);

void ubx(benchmark::State& state) { scan_and_decode<Ubx>(state, {"ubx/golden.ubx"}); }
BENCHMARK(ubx);

void ubx_and_nmea0183(benchmark::State& state) {
  scan_and_decode<UbxNmea>(state, {"ubx/golden.ubx", "nmea0183/golden.nmea"});
}
BENCHMARK(ubx_and_nmea0183);

void pd0(benchmark::State& state) { scan_and_decode<Pd0>(state, {"pd0/golden.pd0"}); }
BENCHMARK(pd0);

void nortek_ad2cp(benchmark::State& state) {
  scan_and_decode<NortekAd2cp>(state, {"nortek-ad2cp/golden.nortek-ad2cp"});
}
BENCHMARK(nortek_ad2cp);

void wayfinder(benchmark::State& state) {
  scan_and_decode<Wayfinder>(state, {"wayfinder/golden.wayfinder"});
}
BENCHMARK(wayfinder);

/// A description beside the codec written by hand, on the same sentences.
void described_codec(benchmark::State& state, const char* description, const char* file) {
  const auto found = rig_config::find_description(description, "").value();
  const Buffer stream = repeated({file});
  const auto framer = std::make_unique<Framer<described::longest_frame>>();
  const auto record = std::make_unique<described::Record>();
  std::size_t messages = 0;
  for (auto _ : state) {
    for (std::size_t at = 0; at < stream.size(); at += piece) {
      const Bytes bytes = Bytes{stream}.subspan(at, std::min(piece, stream.size() - at));
      framer->feed(bytes, described::Scanner{&found->plan}, [&](Bytes frame, std::size_t) {
        messages += decode(found->plan, frame, *record) == described::Decoded::message;
        benchmark::DoNotOptimize(record.get());
      });
    }
  }
  const auto rounds = static_cast<std::int64_t>(state.iterations());
  state.SetBytesProcessed(rounds * static_cast<std::int64_t>(stream.size()));
  state.SetItemsProcessed(static_cast<std::int64_t>(messages));
}

void water_linked(benchmark::State& state) {
  scan_and_decode<WaterLinked>(state, {"described/water-linked-wrz.txt"});
}
BENCHMARK(water_linked);
BENCHMARK_CAPTURE(described_codec, water_linked, "water-linked-wrz.toml",
                  "described/water-linked-wrz.txt");

void nortek(benchmark::State& state) { scan_and_decode<Nortek>(state, {"nortek/golden.nmea"}); }
BENCHMARK(nortek);
BENCHMARK_CAPTURE(described_codec, nortek, "nortek-bt.toml", "nortek/golden.nmea");

void nmea0183_headings(benchmark::State& state) {
  scan_and_decode<Nmea0183>(state, {"described/nmea-heading.txt"});
}
BENCHMARK(nmea0183_headings);
BENCHMARK_CAPTURE(described_codec, nmea0183_headings, "nmea-heading.toml",
                  "described/nmea-heading.txt");

void keller(benchmark::State& state) {
  described_codec(state, "keller.toml", "described/keller.bin");
}
BENCHMARK(keller);

/// A line at the wrong baud rate: only noise.
template <class P>
void skip_noise(benchmark::State& state) {
  Buffer stream(stream_size);
  std::uint32_t word = 1;
  for (auto& byte : stream) {
    word = word * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(word >> 24);
  }
  const auto framer = std::make_unique<Framer<P::max_frame>>();
  for (auto _ : state) framer->feed(stream, P::scan, [](Bytes, std::size_t) {});
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) *
                          static_cast<std::int64_t>(stream.size()));
}

BENCHMARK(skip_noise<Nmea0183>);
BENCHMARK(skip_noise<Ubx>);
BENCHMARK(skip_noise<UbxNmea>);
BENCHMARK(skip_noise<Pd0>);
BENCHMARK(skip_noise<NortekAd2cp>);

}  // namespace
}  // namespace drydock::wire
