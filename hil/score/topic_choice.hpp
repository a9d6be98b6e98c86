#pragma once

#include <boost/system/result.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "hil/score/message_state.hpp"
#include "hil/score/track.hpp"

namespace drydock::score {

/// The topics of an MCAP file that can be read as estimates, by name.
using EstimateTopics = std::map<std::string, const MessageType*>;

struct TopicChoice {
  std::vector<std::string>
      topics;        ///< of one estimator; the first one counts where two say a thing
  std::string note;  ///< others that could be read; empty: none
};

/// `wanted`: the topic that a person names. Empty: the only one of the type that tells most. The
/// truth and measurements (`devices` of a run's recording) are no estimates unless they are named.
boost::system::result<TopicChoice, Problem> choose_topics(const EstimateTopics& topics,
                                                          const std::set<std::string>& devices,
                                                          const std::string& wanted);

}  // namespace drydock::score
