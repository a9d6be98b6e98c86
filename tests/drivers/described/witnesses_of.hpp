#pragma once

#include <string>

namespace drydock::described::test {

/// The witnesses of a protocol or of a description in tests/witnesses: captures and programs of
/// others, or if there are none, bytes packed from documents. A claim about many protocols does not
/// tell who confirms which: one about more than two counts only if there is no other, and one about
/// more than four never. `kind`: protocols, descriptions.
std::string witness_cell(const std::string& kind, const std::string& about);

}  // namespace drydock::described::test
