#include "drivers/host/follower.hpp"

#include <gmock/gmock.h>

#include <string>

namespace drydock::host {
namespace followers_test {

using testing::ElementsAre;

/// Writes down what it is told.
class Note final : public Follower {
 public:
  Note(std::string name, std::vector<std::string>& told) : name_(std::move(name)), told_(told) {}
  void on_estimate(const Estimate&) override { told_.push_back(name_ + " estimate"); }
  void on_truth(const Estimate&) override { told_.push_back(name_ + " truth"); }

 private:
  std::string name_;
  std::vector<std::string>& told_;
};

/// Tells the others a truth when it hears an estimate.
class Teller final : public Follower {
 public:
  explicit Teller(Follower& to) : to_(to) {}
  void on_estimate(const Estimate&) override { to_.on_truth({}); }

 private:
  Follower& to_;
};

TEST(Followers, HearInTheirOrderAndWhatOneTellsComesBeforeTheRest) {
  std::vector<std::string> told;
  Followers followers;
  Note first("first", told), second("second", told);
  Teller teller(followers);
  followers.add(first);
  followers.add(teller);
  followers.add(second);
  followers.on_estimate({});
  EXPECT_THAT(told,
              ElementsAre("first estimate", "first truth", "second truth", "second estimate"));
}

TEST(HealthReport, MakesItsTextOnceAndOnlyForThoseWhoAsk) {
  int made = 0;
  const HealthReport health([&made] {
    ++made;
    HealthReport::Statuses statuses(1);
    statuses.front().name = "dvl";
    return statuses;
  });
  EXPECT_EQ(made, 0);
  EXPECT_EQ(health.statuses().front().name, "dvl");
  EXPECT_EQ(health.statuses().size(), 1u);
  EXPECT_EQ(made, 1);
}

}  // namespace followers_test
}  // namespace drydock::host
