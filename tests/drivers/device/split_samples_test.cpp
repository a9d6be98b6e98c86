#include <bit>
#include <cmath>
#include <functional>
#include <random>

#include "tests/drivers/device/support.hpp"

/// Samples of several frames without a count, read by a host that is now and then late. Bytes by
/// the makers' tables; each value of sample k says k, so a sample of two samples shows.
namespace drydock::device::test {
namespace split_samples_test {

using measurement::ImuSample;

constexpr double period_s = 0.01, frame_s = 0.0003;
// Samples at the beginning that are read at once, so that the driver learns the device's pace, and
// at the end, so that it need not guess what would have come.
constexpr int calm = 40, tail = 20;

struct Sensor {
  std::string protocol;
  std::function<std::vector<wire::CanFrame>(int)> frames;          ///< of sample k
  std::function<std::array<double, 2>(const ImuSample&)> numbers;  ///< k by its rate, by its force
};

wire::CanFrame sae(std::uint32_t id, int k, unsigned latency) {
  const auto raw = static_cast<unsigned>(32000 + k);
  return can_frame(id, true, {raw & 0xFF, raw >> 8, 0x00, 0x7D, 0x00, 0x7D, 0x00, latency});
}

wire::CanFrame tpdo(std::uint32_t id, float first, float second) {
  Octets bytes(8);
  put(bytes, 0, 4, std::bit_cast<std::int32_t>(first));
  put(bytes, 4, 4, std::bit_cast<std::int32_t>(second));
  wire::CanFrame frame{.id = id, .size = 8};
  std::copy(bytes.begin(), bytes.end(), frame.data.begin());
  return frame;
}

double number_of_rate(double radps) { return radps / degree * 128; }

std::vector<Sensor> sensors() {
  const auto first_axis = [](const ImuSample& s) {
    return std::array{number_of_rate(s.angular_rate.x()), s.specific_force.x() * 100};
  };
  const auto lateral = [](const ImuSample& s) {
    return std::array{number_of_rate(s.angular_rate.y()), s.specific_force.y() * 100};
  };
  const auto floats = [](const ImuSample& s) {
    return std::array{s.angular_rate.x() * 1000, s.specific_force.z() * 100};
  };
  return {
      {"aceinna",
       [](int k) {
         return std::vector{sae(0x08F02D80, k, 0xFF), sae(0x0CF02A80, k, 6)};
       },
       first_axis},
      {"aceinna",  // the rate first, as other firmware has it
       [](int k) {
         return std::vector{sae(0x0CF02A80, k, 6), sae(0x08F02D80, k, 0xFF)};
       },
       first_axis},
      {"microstrain-mv5",
       [](int k) {
         return std::vector{sae(0x08F02DE2, k, 0xFF), sae(0x0CF02AE2, k, 6)};
       },
       lateral},
      {"cia404-imu",
       [](int k) {
         const auto rate = static_cast<float>(k) / 1000, force = static_cast<float>(k) / 100;
         return std::vector{tpdo(0x181, rate, rate), tpdo(0x281, rate, force),
                            tpdo(0x381, force, force)};
       },
       floats},
  };
}

struct Read {
  wire::CanFrame frame;
  int sample;
  double at;
};

/// When a frame that came on the bus at this time is read.
using Reader = std::function<double(double)>;

/// The frames in the bus's order, none read before the one in front of it.
std::vector<Read> reads(const Sensor& sensor, int samples, const Reader& reader) {
  std::vector<Read> all;
  for (int k = 0; k < samples; ++k) {
    double on_bus = 1 + k * period_s;
    const bool is_calm = k < calm || k >= samples - tail;
    for (const auto& frame : sensor.frames(k)) {
      on_bus += frame_s;
      const double read_at = is_calm ? on_bus : reader(on_bus);
      all.push_back({frame, k, std::max(read_at, all.empty() ? 0 : all.back().at)});
    }
  }
  return all;
}

struct Heard {
  Heard(const Sensor& s, const std::vector<Read>& all)
      : sensor(s), driver(frame_driver(options(Kind::imu, s.protocol))) {
    for (const Read& read : all) driver->receive(read.frame, at_s(read.at), ear);
    driver->finish(ear);
  }

  /// The number of each sample; fails for one that mixes two.
  std::vector<int> numbers() const {
    std::vector<int> found;
    for (const auto& s : ear.all<ImuSample>()) {
      const auto [rate, force] = sensor.numbers(s);
      EXPECT_NEAR(rate, force, 0.01) << sensor.protocol << ": halves of two samples";
      found.push_back(static_cast<int>(std::lround(rate)));
    }
    return found;
  }
  std::uint64_t counted() const { return ear.refusals.size() + driver->counters().bad_checksums; }

  const Sensor& sensor;
  Ear ear;
  std::unique_ptr<FrameDriver> driver;
};

/// Every frame late by its own time, up to `most`.
Reader late_at_random(unsigned seed, double most_s) {
  return [random = std::mt19937(seed), most_s](double on_bus) mutable {
    return on_bus + std::uniform_real_distribution(0.0, most_s)(random);
  };
}

/// Reads at whole multiples of `every`, all that is there.
Reader polling(double every_s, double phase_s) {
  return [=](double on_bus) { return phase_s + std::ceil((on_bus - phase_s) / every_s) * every_s; };
}

/// Stops now and then for up to `most`, and reads at once in between, for up to `between`.
Reader stopping(unsigned seed, double most_s, double between_s = 0.1) {
  return [random = std::mt19937(seed), most_s, between_s, from = 0.0,
          until = 0.0](double on_bus) mutable {
    if (on_bus > until) {
      from = on_bus + std::uniform_real_distribution(0.0, between_s)(random);
      until = from + std::uniform_real_distribution(0.0, most_s)(random);
    }
    return on_bus >= from ? std::max(on_bus, until) : on_bus;
  };
}

std::vector<Reader> readers_up_to(double most_s) {
  std::vector<Reader> all;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    all.push_back(late_at_random(seed, most_s));
    all.push_back(late_at_random(seed, most_s / 2));
    all.push_back(stopping(seed, most_s));
    all.push_back(polling(most_s, 0.0003 * seed));
    all.push_back(polling(most_s * 0.617, 0.0007 * seed));
  }
  return all;
}

/// Those of the samples that were not published, in the order in which they should have been.
std::vector<int> missing(const Heard& heard, int samples) {
  const auto numbers = heard.numbers();
  EXPECT_TRUE(std::ranges::is_sorted(numbers));
  std::vector<int> all;
  for (int k = 0; k < samples; ++k)
    if (!std::ranges::binary_search(numbers, k)) all.push_back(k);
  return all;
}

TEST(SplitSamples, AreTheSameWhereverReadsCutThemUpToAPeriodLate) {
  constexpr int samples = 600;
  for (const Sensor& sensor : sensors()) {
    for (const Reader& reader : readers_up_to(0.98 * period_s)) {
      const Heard heard(sensor, reads(sensor, samples, reader));
      EXPECT_EQ(missing(heard, samples), std::vector<int>{}) << sensor.protocol;
      EXPECT_EQ(heard.counted(), 0U) << sensor.protocol;
    }
  }
}

TEST(SplitSamples, AreTrueBeforeTheirFirstFrameWasReadHoweverLateTheLastCame) {
  for (const Sensor& sensor : sensors()) {
    const auto all = reads(sensor, 300, late_at_random(7, 0.98 * period_s));
    const auto samples = Heard(sensor, all).ear.all<ImuSample>();
    ASSERT_EQ(samples.size(), 300U) << sensor.protocol;
    const auto age = [&](int k) {  // since the first frame was read
      const auto first = std::ranges::find(all, k, &Read::sample);
      return measurement::seconds(at_s(first->at) -
                                  samples[static_cast<std::size_t>(k)].origin.valid_at);
    };
    for (int k = calm; k < 300; ++k) {
      EXPECT_LT(std::abs(age(k) - age(0)), 0.001) << sensor.protocol << ' ' << k;
      const auto last = std::find_if(all.rbegin(), all.rend(),
                                     [&](const Read& read) { return read.sample == k; });
      EXPECT_EQ(samples[static_cast<std::size_t>(k)].origin.received_at, at_s(last->at));
    }
  }
}

TEST(SplitSamples, AFrameThatIsLostCostsItsSampleAloneAndIsCounted) {
  constexpr int samples = 300, broken = 150;
  for (const Sensor& sensor : sensors()) {
    for (std::size_t place = 0; place < sensor.frames(0).size(); ++place) {
      for (const Reader& reader : readers_up_to(0.98 * period_s)) {
        auto all = reads(sensor, samples, reader);
        const auto first = std::ranges::find(all, broken, &Read::sample);
        all.erase(first + static_cast<std::ptrdiff_t>(place));
        const Heard heard(sensor, all);
        EXPECT_EQ(missing(heard, samples), std::vector{broken}) << sensor.protocol << place;
        EXPECT_EQ(heard.counted(), 1U) << sensor.protocol << place;
      }
    }
  }
}

/// The order of what is left is right, and only the device's pace shows that it is two samples.
TEST(SplitSamples, TheEndOfOneAndTheBeginningOfTheNextLostAreTwoSamplesAndNoMixture) {
  constexpr int samples = 300, broken = 150;
  const auto at_once = [](double on_bus) { return on_bus; };
  for (const Sensor& sensor : sensors()) {
    for (const Reader& reader : {Reader(at_once), stopping(3, 0.5 * period_s)}) {
      auto all = reads(sensor, samples, reader);
      const auto of_sample = std::ranges::find(all, broken, &Read::sample);
      const auto frames = static_cast<std::ptrdiff_t>(sensor.frames(0).size());
      all.erase(of_sample + 1, of_sample + 1 + frames);
      const Heard heard(sensor, all);
      EXPECT_EQ(missing(heard, samples), (std::vector{broken, broken + 1})) << sensor.protocol;
      EXPECT_EQ(heard.counted(), 1U) << sensor.protocol;
    }
  }
}

TEST(SplitSamples, AHostThatStopsForManyPeriodsLosesNoneOfThoseThatItReadsAfterwards) {
  constexpr int samples = 2000;
  for (const Sensor& sensor : sensors()) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      const Heard heard(sensor, reads(sensor, samples, stopping(seed, 20 * period_s, 1)));
      EXPECT_EQ(missing(heard, samples), std::vector<int>{}) << sensor.protocol;
      EXPECT_EQ(heard.counted(), 0U) << sensor.protocol;
    }
  }
}

}  // namespace split_samples_test
}  // namespace drydock::device::test
