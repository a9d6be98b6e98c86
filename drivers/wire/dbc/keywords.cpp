#include "drivers/wire/dbc/keywords.hpp"

#include <algorithm>
#include <array>

namespace drydock::wire::dbc {

namespace {

constexpr auto read_words = std::to_array<std::string_view>(
    {"VERSION", "NS_", "BS_", "BU_", "BO_", "SG_", "BO_TX_BU_", "CM_", "BA_DEF_", "BA_DEF_DEF_",
     "BA_", "VAL_", "SIG_VALTYPE_", "SG_MUL_VAL_"});

constexpr auto skipped_words = std::to_array<std::string_view>(
    {"VAL_TABLE_",       "EV_",        "ENVVAR_DATA_", "EV_DATA_",      "SGTYPE_",
     "SGTYPE_VAL_",      "BA_SGTYPE_", "SIG_GROUP_",   "SIG_TYPE_REF_", "BA_DEF_SGTYPE_",
     "SIGTYPE_VALTYPE_", "BA_REL_",    "BA_DEF_REL_",  "BU_SG_REL_",    "BA_DEF_DEF_REL_",
     "BU_EV_REL_",       "BU_BO_REL_", "CAT_DEF_",     "CAT_",          "FILTER",
     "NS_DESC_"});

}  // namespace

bool is_keyword(std::string_view word) {
  return std::ranges::find(read_words, word) != read_words.end() || is_skipped(word);
}

bool is_skipped(std::string_view word) {
  return std::ranges::find(skipped_words, word) != skipped_words.end();
}

}  // namespace drydock::wire::dbc
