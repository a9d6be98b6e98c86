#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "estimators/external/answer.hpp"
#include "estimators/external/values.hpp"

namespace drydock::external {

/// Reads one estimate of an answer. After the first flaw its values mean nothing.
class EstimateReader {
 public:
  EstimateReader(const nlohmann::json& estimate, Gives gives)
      : estimate_(estimate), gives_(gives) {}

  pipeline::OutsideEstimate read();
  Answer::Flaw flaw() const { return flaw_; }
  const std::string& what() const { return what_; }

 private:
  bool has(const char* key) const { return estimate_.contains(key); }
  void fail(Answer::Flaw flaw, std::string what);
  double number(const nlohmann::json& value, const char* key);
  double within(const char* key, double limit);
  double turns(const char* key);
  bool yes_or_no(const char* key);
  Eigen::Vector3d three(const char* key);
  Eigen::Matrix3d nine(const char* key);
  Eigen::Matrix3d squares(const char* key);
  std::optional<Eigen::Matrix3d> covariance(const char* sigma, const char* full, double unit);
  std::optional<Eigen::Vector3d> angles();
  std::optional<frame::Position> position();
  Values values();
  void must_give(const Values& values);
  void must_know_its_keys();

  const nlohmann::json& estimate_;
  Gives gives_;
  Answer::Flaw flaw_ = Answer::Flaw::none;
  std::string what_;
};

}  // namespace drydock::external
