#include "drivers/wire/j1939/pgn_name.hpp"

#include <algorithm>
#include <array>

namespace drydock::wire::j1939 {
namespace {

struct NamedGroup {
  std::uint32_t pgn;
  std::string_view name;
};
constexpr std::array named_groups{NamedGroup{0, "torque and speed control"},
                                  NamedGroup{256, "transmission control"},
                                  NamedGroup{1024, "external brake request"},
                                  NamedGroup{57344, "cab message 1"},
                                  NamedGroup{59136, "reset"},
                                  NamedGroup{59904, "request"},
                                  NamedGroup{60928, "address claimed"},
                                  NamedGroup{61440, "retarder"},
                                  NamedGroup{61441, "brake controller"},
                                  NamedGroup{61442, "transmission controller 1"},
                                  NamedGroup{61443, "engine controller 2"},
                                  NamedGroup{61444, "engine controller 1"},
                                  NamedGroup{61445, "transmission controller 2"},
                                  NamedGroup{61449, "vehicle dynamic stability 2"},
                                  NamedGroup{64965, "ECU identification"},
                                  NamedGroup{65132, "tachograph"},
                                  NamedGroup{65213, "fan drive"},
                                  NamedGroup{65215, "wheel speeds"},
                                  NamedGroup{65217, "vehicle distance, high resolution"},
                                  NamedGroup{65226, "active trouble codes"},
                                  NamedGroup{65227, "previous trouble codes"},
                                  NamedGroup{65228, "trouble codes cleared"},
                                  NamedGroup{65242, "software identification"},
                                  NamedGroup{65247, "engine controller 3"},
                                  NamedGroup{65248, "vehicle distance"},
                                  NamedGroup{65249, "retarder configuration"},
                                  NamedGroup{65250, "transmission configuration"},
                                  NamedGroup{65251, "engine configuration"},
                                  NamedGroup{65252, "shutdown"},
                                  NamedGroup{65253, "engine hours"},
                                  NamedGroup{65254, "time and date"},
                                  NamedGroup{65255, "vehicle hours"},
                                  NamedGroup{65256, "vehicle direction and speed"},
                                  NamedGroup{65257, "fuel consumption"},
                                  NamedGroup{65258, "vehicle weight"},
                                  NamedGroup{65259, "component identification"},
                                  NamedGroup{65260, "vehicle identification"},
                                  NamedGroup{65261, "cruise control setup"},
                                  NamedGroup{65262, "engine temperature"},
                                  NamedGroup{65263, "engine fluid level and pressure"},
                                  NamedGroup{65264, "power takeoff"},
                                  NamedGroup{65265, "cruise control and vehicle speed"},
                                  NamedGroup{65266, "fuel economy"},
                                  NamedGroup{65267, "vehicle position"},
                                  NamedGroup{65268, "tire condition"},
                                  NamedGroup{65269, "ambient conditions"},
                                  NamedGroup{65270, "inlet and exhaust conditions"},
                                  NamedGroup{65271, "vehicle electrical power"},
                                  NamedGroup{65272, "transmission fluids"},
                                  NamedGroup{65276, "dash display"}};

}  // namespace

std::string_view pgn_name(std::uint32_t pgn) {
  const auto found = std::ranges::find(named_groups, pgn, &NamedGroup::pgn);
  return found == named_groups.end() ? std::string_view() : found->name;
}

}  // namespace drydock::wire::j1939
