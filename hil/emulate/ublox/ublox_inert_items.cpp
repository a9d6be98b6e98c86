#include "hil/emulate/ublox/ublox_inert_items.hpp"

#include <array>

namespace drydock::emulate::ublox {
namespace {

constexpr ItemFacts flag(std::uint32_t key, Group group, std::uint64_t value) {
  return {key, group, value, value, 0, 1};
}

// UART1 is 8N1; another form is refused, as no line here could follow.
constexpr auto inert = std::to_array<ItemFacts>({
    {0x20520002, ports, 1, 1, 1, 1},                  // UART1-STOPBITS: one
    {0x20520003, ports, 0, 0, 0, 0},                  // UART1-DATABITS: eight
    {0x20520004, ports, 0, 0, 0, 0},                  // UART1-PARITY: none
    {0x10520005, ports, 1, 1, 1, 1},                  // UART1-ENABLED
    flag(0x10730004, ports, 1),                       // UART1INPROT-RTCM3X
    flag(0x10740004, ports, 1),                       // UART1OUTPROT-RTCM3X
    {0x40530001, ports, 38400, 38400, 4800, 921600},  // UART2-BAUDRATE
    {0x20530002, ports, 1, 1, 0, 3},
    {0x20530003, ports, 0, 0, 0, 1},
    {0x20530004, ports, 0, 0, 0, 2},
    flag(0x10530005, ports, 1),
    flag(0x10750001, ports, 0),  // UART2INPROT
    flag(0x10750002, ports, 0),
    flag(0x10750004, ports, 1),
    flag(0x10760001, ports, 0),  // UART2OUTPROT
    flag(0x10760002, ports, 0),
    flag(0x10760004, ports, 1),
    flag(0x10710001, ports, 1),  // I2CINPROT
    flag(0x10710002, ports, 1),
    flag(0x10710004, ports, 1),
    flag(0x10720001, ports, 1),  // I2COUTPROT
    flag(0x10720002, ports, 1),
    flag(0x10720004, ports, 1),
    flag(0x10770001, ports, 1),  // USBINPROT
    flag(0x10770002, ports, 1),
    flag(0x10770004, ports, 1),
    flag(0x10780001, ports, 1),  // USBOUTPROT
    flag(0x10780002, ports, 1),
    flag(0x10780004, ports, 1),
    flag(0x10790001, ports, 1),  // SPIINPROT
    flag(0x10790002, ports, 1),
    flag(0x10790004, ports, 1),
    flag(0x107A0001, ports, 1),  // SPIOUTPROT
    flag(0x107A0002, ports, 1),
    flag(0x107A0004, ports, 1),
    flag(0x10220001, navigation, 0),                // ODO-USE_ODO
    flag(0x10220002, navigation, 0),                // ODO-USE_COG
    flag(0x10220003, navigation, 0),                // ODO-OUTLPVEL
    flag(0x10220004, navigation, 0),                // ODO-OUTLPCOG
    {0x20220005, navigation, 0, 0, 0, 4},           // ODO-PROFILE
    {0x20410001, receiver, 3, 3, 0, 255},           // ITFM-BBTHRESHOLD
    {0x20410002, receiver, 15, 15, 0, 255},         // ITFM-CWTHRESHOLD
    flag(0x1041000D, receiver, 0),                  // ITFM-ENABLE
    {0x20410010, receiver, 0, 0, 0, 2},             // ITFM-ANTSETTING
    flag(0x10410013, receiver, 0),                  // ITFM-ENABLE_AUX
    {0x20140011, navigation, 3, 3, 2, 3},           // NAVHPG-DGNSSMODE
    {0x40030010, navigation, 0, 0, 0, 0xFFFFFFFF},  // TMODE-SVIN_MIN_DUR
    {0x40030011, navigation, 0, 0, 0, 0xFFFFFFFF},  // TMODE-SVIN_ACC_LIMIT
    {0x20920001, receiver, 0, 0, 0, 255},           // INFMSG-UBX_I2C and the other ports
    {0x20920002, receiver, 0, 0, 0, 255},
    {0x20920003, receiver, 0, 0, 0, 255},
    {0x20920004, receiver, 0, 0, 0, 255},
    {0x20920005, receiver, 0, 0, 0, 255},
    {0x20920006, receiver, 7, 7, 0, 255},  // INFMSG-NMEA_I2C and the other ports
    {0x20920007, receiver, 7, 7, 0, 255},
    {0x20920008, receiver, 7, 7, 0, 255},
    {0x20920009, receiver, 7, 7, 0, 255},
    {0x2092000A, receiver, 7, 7, 0, 255},
});

constexpr bool only_f9 = false;

constexpr auto unsent = std::to_array<MessageFacts>({
    {0x0134, 0x20910010},              // NAV-ORB
    {0x0101, 0x20910024},              // NAV-POSECEF
    {0x0111, 0x2091003D},              // NAV-VELECEF
    {0x0126, 0x20910060},              // NAV-TIMELS
    {0x0122, 0x20910065},              // NAV-CLOCK
    {0x0132, 0x2091006A},              // NAV-SBAS
    {0x0109, 0x2091007E},              // NAV-ODO
    {0x0139, 0x209100A1},              // NAV-GEOFENCE
    {0x0123, 0x2091004C},              // NAV-TIMEGLO
    {0x0124, 0x20910051},              // NAV-TIMEBDS
    {0x0125, 0x20910056},              // NAV-TIMEGAL
    {0xF00A, 0x209100A6},              // DTM
    {0xF00D, 0x209100B5},              // GNS
    {0xF006, 0x209100CE},              // GRS
    {0xF007, 0x209100D3},              // GST
    {0xF009, 0x209100DD},              // GBS
    {0xF00F, 0x209100E7},              // VLW
    {0xF100, 0x209100EC},              // PUBX,00
    {0xF103, 0x209100F1},              // PUBX,03
    {0xF104, 0x209100F6},              // PUBX,04
    {0x0D01, 0x2091017D},              // TIM-TP
    {0x0D06, 0x20910092},              // TIM-VRFY
    {0x0A21, 0x20910187},              // MON-RXR
    {0x0A06, 0x20910196},              // MON-MSGPP
    {0x0A08, 0x2091019B},              // MON-TXBUF
    {0x0A07, 0x209101A0},              // MON-RXBUF
    {0x0A02, 0x209101A5},              // MON-IO
    {0x0214, 0x20910204},              // RXM-MEASX
    {0x0213, 0x20910231},              // RXM-SFRBX
    {0x2108, 0x20910259},              // LOG-INFO
    {0x0131, 0},                       // NAV-DGPS
    {0x0160, 0},                       // NAV-AOPSTATUS
    {0x0220, 0},                       // RXM-SVSI
    {0x0259, 0},                       // RXM-RLM
    {0x0113, 0x2091002E, 0, only_f9},  // NAV-HPPOSECEF
    {0x0114, 0x20910033, 0, only_f9},  // NAV-HPPOSLLH
    {0x0136, 0x20910083, 0, only_f9},  // NAV-COV
    {0x013B, 0x20910088, 0, only_f9},  // NAV-SVIN
    {0x013C, 0x2091008D, 0, only_f9},  // NAV-RELPOSNED
    {0x0143, 0x20910345, 0, only_f9},  // NAV-SIG
    {0x0215, 0x209102A4, 0, only_f9},  // RXM-RAWX
    {0x0232, 0x20910268, 0, only_f9},  // RXM-RTCM
    {0xF505, 0x209102BD, 0, only_f9},  // RTCM 1005
    {0xF54D, 0x209102CC, 0, only_f9},  // RTCM 1077
    {0xF557, 0x209102D1, 0, only_f9},  // RTCM 1087
    {0xF57F, 0x209102D6, 0, only_f9},  // RTCM 1127
    {0xF5FE, 0x209102FE, 0, only_f9},  // RTCM 4072.0
    {0xF5E6, 0x20910303, 0, only_f9},  // RTCM 1230
    {0xF561, 0x20910318, 0, only_f9},  // RTCM 1097
    {0x0A36, 0x2091034F, 0, only_f9},  // MON-COMMS
    {0x0A37, 0x20910354, 0, only_f9},  // MON-HW3
    {0xF54A, 0x2091035E, 0, only_f9},  // RTCM 1074
    {0xF554, 0x20910363, 0, only_f9},  // RTCM 1084
    {0xF55E, 0x20910368, 0, only_f9},  // RTCM 1094
    {0xF57C, 0x2091036D, 0, only_f9},  // RTCM 1124
    {0xF5FD, 0x20910381, 0, only_f9},  // RTCM 4072.1
    {0x0A31, 0x2091038B, 0, only_f9},  // MON-SPAN
});

}  // namespace

std::span<const ItemFacts> inert_items() { return inert; }
std::span<const MessageFacts> unsent_messages() { return unsent; }

}  // namespace drydock::emulate::ublox
