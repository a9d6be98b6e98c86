#pragma once

#include <string>

#include "hil/campaign/plan/campaign_file.hpp"

namespace drydock::campaign {

/// The command line that repeats one run alone, as a shell takes it. A run with files of its own
/// is repeated by the program, with the campaign's file at `path`.
std::string repeat_command(const CampaignConfig& campaign, const std::string& path,
                           std::size_t index);

/// `word` as one word of a POSIX shell.
std::string shell_word(const std::string& word);

}  // namespace drydock::campaign
