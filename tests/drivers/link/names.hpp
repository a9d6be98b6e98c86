#pragma once

#include <string>
#include <vector>

/// The name server of a test program: names.cpp stands in for the C library's getaddrinfo.
namespace drydock::link::testing::names {

/// The name has these addresses from now on.
void answer(const std::string& host, const std::vector<std::string>& addresses);

/// A look-up of the name hangs from now on, until release(). It ends after 3 s in any case, so that
/// a test that fails also ends.
void hang(const std::string& host);
/// Ends the look-ups that hang, and waits until they have ended.
void release();

int hanging();  ///< look-ups that hang now
int lookups();  ///< all calls so far, also those for numbers
}  // namespace drydock::link::testing::names
