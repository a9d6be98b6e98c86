#include <gtest/gtest.h>

#include "drivers/capture/format.hpp"
#include "drivers/link/uri.hpp"

namespace drydock::link {
namespace {

std::string error_of(std::string_view text) {
  const auto uri = parse_uri(text);
  return uri ? "no error" : uri.error().message;
}

TEST(Uri, NamesSchemeTargetAndKeys) {
  const Uri uri = parse_uri("serial:/dev/ttyUSB0?baud=115200&parity=even").value();
  EXPECT_EQ(uri.scheme, Scheme::serial);
  EXPECT_EQ(uri.target, "/dev/ttyUSB0");
  EXPECT_EQ(uri.baud(), 115'200U);
  EXPECT_EQ(uri.query.at("parity"), "even");
  EXPECT_EQ(uri.text, "serial:/dev/ttyUSB0?baud=115200&parity=even");
  EXPECT_EQ(uri.bitrate(), std::nullopt);
}

TEST(Uri, OfAFileHasItsQuestionMarksEscapedAndGivesTheNameBack) {
  EXPECT_EQ(file_uri("a?b&c 100%.pd0"), "file:a%3Fb&c 100%25.pd0");
  for (const std::string name : {"a?b&c 100%.pd0", "%3F", "%", "dive.log", "50%4"}) {
    const Uri uri = parse_uri(file_uri(name) + "?speed=max&baud=9600").value();
    EXPECT_EQ(uri.target, name);
    EXPECT_EQ(uri.baud(), 9600U);
  }
  EXPECT_EQ(parse_uri("file:100%.log?baud=9600").value().target, "100%.log") << "as people type it";
}

TEST(Uri, TellsBytesFromFrames) {
  for (const char* text :
       {"serial:/dev/ttyS0?baud=9600", "pty:x", "tcp:h:1", "udp:h:1", "file:f", "memory:m"})
    EXPECT_EQ(parse_uri(text).value().carries(), Carries::bytes) << text;
  for (const char* text : {"socketcan:can0", "slcan:/dev/ttyACM0", "memory-can:b", "can:auto"})
    EXPECT_EQ(parse_uri(text).value().carries(), Carries::frames) << text;
}

TEST(Uri, SaysWhichDevicesAreEmulated) {
  for (const char* text :
       {"pty:x", "memory:m", "memory-can:b", "can:auto", "socketcan:vcan0", "slcan:pty:bus",
        "tcp:localhost:4001?emulated=1", "slcan:/dev/ttyACM0?emulated=1"})
    EXPECT_TRUE(parse_uri(text).value().emulated()) << text;
  for (const char* text : {"serial:/dev/ttyS0?baud=9600", "tcp:h:1", "udp:h:1", "socketcan:can0",
                           "slcan:/dev/ttyACM0", "slcan:tcp:gateway:3333", "file:f"})
    EXPECT_FALSE(parse_uri(text).value().emulated()) << text;
  EXPECT_TRUE(parse_uri("file:f").value().recorded());
}

TEST(Uri, CanBitRateIsThatOfMarineBusesUnlessWritten) {
  EXPECT_EQ(parse_uri("socketcan:can0").value().bitrate(), 250'000U);
  EXPECT_EQ(parse_uri("can:auto?name=bus0&bitrate=500000").value().bitrate(), 500'000U);
  EXPECT_EQ(parse_uri("file:can.log?bitrate=500000").value().bitrate(), 500'000U);
  EXPECT_EQ(parse_uri("file:can.log?data_bitrate=2000000").value().data_bitrate(), 2'000'000U);
  EXPECT_EQ(parse_uri("can:auto?name=bus0").value().target, "bus0");
  EXPECT_EQ(parse_uri("can:auto").value().target, "vcan0");
}

TEST(Uri, SlcanRunsOverAnyByteLink) {
  const Uri port = line_under(parse_uri("slcan:/dev/ttyACM0?baud=1000000").value());
  EXPECT_EQ(port.text, "serial:/dev/ttyACM0?baud=1000000");
  EXPECT_EQ(line_under(parse_uri("slcan:tcp:gateway:3333").value()).text, "tcp:gateway:3333");
}

TEST(Uri, AGatewayRunsOverAnyByteLinkAndItsDatagramsComeToAPortOfThisComputer) {
  const Uri tcp = parse_uri("gateway:tcp:192.168.4.1:1457?format=ydwg").value();
  EXPECT_EQ(line_under(tcp).text, "tcp:192.168.4.1:1457");
  EXPECT_EQ(tcp.bitrate(), 250'000U) << "the rate of NMEA 2000";
  const Uri udp = parse_uri("gateway:udp:0.0.0.0:2000").value();
  EXPECT_EQ(line_under(udp).text, "udp:0.0.0.0:2000?listen=1");
  EXPECT_TRUE(parse_uri("gateway:pty:bus").value().emulated());
  EXPECT_FALSE(tcp.only_listens());
  for (const char* text : {"gateway:tcp:h:1?format=actisense", "gateway:tcp:h:1?format=ikonvert"})
    EXPECT_TRUE(parse_uri(text).value().only_listens()) << "it takes no frames: " << text;
  EXPECT_EQ(error_of("gateway:tcp:h:1?format=asc"),
            "\"gateway:tcp:h:1?format=asc\": bad format \"asc\"; allowed: ydwg actisense ikonvert");
}

TEST(Uri, ModeListenIsListen1OnEveryCanLinkAndOnNoOther) {
  for (const char* text :
       {"socketcan:can0?mode=listen", "slcan:/dev/ttyACM0?mode=listen",
        "gateway:tcp:h:1?mode=listen", "memory-can:b?mode=listen", "can:auto?mode=listen"}) {
    const Uri uri = parse_uri(text).value();
    EXPECT_TRUE(uri.only_listens()) << text;
    EXPECT_EQ(uri.text_of("listen"), "1") << text;
  }
  EXPECT_EQ(error_of("socketcan:can0?mode=active"),
            "\"socketcan:can0?mode=active\": bad mode \"active\"; allowed: listen");
  EXPECT_FALSE(parse_uri("udp:0.0.0.0:2000?mode=listen"));
}

TEST(Uri, AnSlcanAdapterSearchesTheRateOnlyWhileItListens) {
  const Uri uri = parse_uri("slcan:/dev/ttyACM0?bitrate=auto&mode=listen").value();
  EXPECT_TRUE(uri.searches_bit_rate());
  EXPECT_EQ(uri.bitrate(), 250'000U) << "until it is found";
  EXPECT_FALSE(parse_uri("slcan:/dev/ttyACM0?bitrate=auto"));
  EXPECT_FALSE(parse_uri("can:auto?bitrate=auto&listen=1"));
}

TEST(Uri, TheFrameOfAByteIsThatOfItsKeys) {
  const auto bits = [](const char* keys) {
    return parse_uri(std::string("serial:/dev/ttyS0?baud=9600") + keys).value().byte_frame().bits();
  };
  EXPECT_EQ(bits(""), 10U);
  EXPECT_EQ(bits("&parity=even"), 11U);
  EXPECT_EQ(bits("&parity=even&stop=2"), 12U);
  EXPECT_EQ(bits("&parity=even&bits=7"), 10U);
  EXPECT_EQ(bits("&bits=5"), 7U);
  EXPECT_EQ(parse_uri("pty:x?baud=4800&parity=odd&stop=2").value().line_rate()->time_of(40),
            std::chrono::milliseconds{100});
}

TEST(Uri, SettingsThatContradictEachOtherAreRefused) {
  const std::string port = "serial:/dev/ttyS0?baud=9600";
  EXPECT_EQ(error_of(port + "&bits=5&stop=2"),
            "\"" + port + "&bits=5&stop=2\": a byte of 5 bits has no 2 stop bits; allowed: stop=1");
  EXPECT_EQ(error_of(port + "&flow=rtscts&rts=1"),
            "\"" + port +
                "&flow=rtscts&rts=1\": with flow=rtscts the port itself sets RTS: leave "
                "out rts");
  EXPECT_EQ(error_of(port + "&flow=rtscts&rs485=high"),
            "\"" + port +
                "&flow=rtscts&rs485=high\": RS-485 has no flow=rtscts: RTS switches the "
                "transmitter");
}

TEST(Uri, AnUnknownSchemeListsAll) {
  EXPECT_EQ(error_of("rs232:/dev/ttyS0"),
            "\"rs232:/dev/ttyS0\": unknown scheme \"rs232\"; allowed are serial pty tcp udp file "
            "memory socketcan slcan gateway memory-can can:auto");
  EXPECT_EQ(error_of("/dev/ttyS0"),
            "\"/dev/ttyS0\": a link is scheme:target; schemes are serial pty tcp udp file memory "
            "socketcan slcan gateway memory-can can:auto");
  EXPECT_EQ(error_of("can:vcan0"),
            "\"can:vcan0\": unknown scheme \"can\"; allowed are serial pty tcp udp file memory "
            "socketcan slcan gateway memory-can can:auto");
}

TEST(Uri, AnUnknownKeyListsThoseOfItsScheme) {
  EXPECT_EQ(error_of("serial:/dev/ttyS0?bauds=9600"),
            "\"serial:/dev/ttyS0?bauds=9600\": unknown key \"bauds\"; serial allows baud bits "
            "parity stop flow dtr rts rs485 emulated");
  EXPECT_EQ(error_of("pty:dvl?flow=none"),
            "\"pty:dvl?flow=none\": unknown key \"flow\"; pty allows baud bits parity stop");
}

TEST(Uri, ABadValueListsWhatIsAllowed) {
  EXPECT_EQ(error_of("pty:dvl?baud=fast"),
            "\"pty:dvl?baud=fast\": bad baud \"fast\"; allowed: 50 to 12000000");
  EXPECT_EQ(error_of("pty:dvl?baud=0"),
            "\"pty:dvl?baud=0\": bad baud \"0\"; allowed: 50 to 12000000");
  EXPECT_EQ(error_of("pty:dvl?baud"),
            "\"pty:dvl?baud\": key \"baud\" has no value; allowed: 50 to 12000000");
  EXPECT_EQ(error_of("serial:/dev/ttyS0?baud=9600&parity=both"),
            "\"serial:/dev/ttyS0?baud=9600&parity=both\": bad parity \"both\"; allowed: none even "
            "odd mark "
            "space");
  EXPECT_EQ(error_of("file:f?speed=-1&baud=9600"),
            "\"file:f?speed=-1&baud=9600\": bad speed \"-1\"; allowed: max, 1 (as fast as the line "
            "was) or "
            "another factor");
  EXPECT_EQ(error_of("slcan:/dev/ttyACM0?bitrate=300000"),
            "\"slcan:/dev/ttyACM0?bitrate=300000\": bad bitrate \"300000\"; allowed: 10000 20000 "
            "50000 100000 "
            "125000 250000 500000 800000 1000000, or auto");
  EXPECT_EQ(error_of("pty:dvl?baud=9600&baud=4800"),
            "\"pty:dvl?baud=9600&baud=4800\": key \"baud\" is given twice");
}

TEST(Uri, ABadTargetShowsAGoodOne) {
  EXPECT_EQ(error_of("tcp:localhost"),
            "\"tcp:localhost\": tcp needs host:port, port 1 to 65535, for example "
            "tcp:192.168.194.95:1037");
  EXPECT_EQ(error_of("tcp:localhost:70000"),
            "\"tcp:localhost:70000\": tcp needs host:port, port 1 to 65535, for example "
            "tcp:192.168.194.95:1037");
  EXPECT_EQ(error_of("pty:a/b"),
            "\"pty:a/b\": pty needs a name without / or an absolute path, for example pty:dvl");
  EXPECT_EQ(error_of("socketcan:an-interface-too-long"),
            "\"socketcan:an-interface-too-long\": socketcan needs an interface name, for example "
            "socketcan:can0");
  EXPECT_EQ(error_of("slcan:file:dive.cap"),
            "\"slcan:file:dive.cap\": slcan needs a device path or one of serial: pty: tcp: udp: "
            "memory: after "
            "it, for example slcan:/dev/ttyACM0?bitrate=250000");
}

TEST(Uri, WhatHasNoSoundDefaultMustBeWritten) {
  EXPECT_EQ(error_of("serial:/dev/ttyS0"),
            "\"serial:/dev/ttyS0\": serial needs a baud rate, for example "
            "serial:/dev/ttyUSB0?baud=115200");
}

TEST(Uri, ARecordingMayNameEveryFormatOfCaptures) {
  std::string allowed = "raw";
  for (const capture::Format& format : capture::formats()) {
    EXPECT_TRUE(parse_uri("file:can.cap?format=" + std::string(format.name)));
    allowed.append(" ").append(format.name);
  }
  EXPECT_EQ(error_of("file:can.cap?format=zip"),
            "\"file:can.cap?format=zip\": bad format \"zip\"; allowed: " + allowed);
}

TEST(Uri, ARecordingMayNameALineOfAFileOfPackets) {
  for (const char* line : {"can1", "/dev/ttyUSB0", "10.0.0.7:16171", "[fe80::1]:9002"})
    EXPECT_TRUE(parse_uri(std::string("file:dive.pcapng?interface=") + line)) << line;
  EXPECT_FALSE(parse_uri("file:dive.pcapng?interface=a b"));
  EXPECT_FALSE(parse_uri(std::string_view("file:dive.pcapng?interface=a\0b", 30)));
  EXPECT_FALSE(parse_uri("udp:127.0.0.1:9?interface=/dev/ttyUSB0"));
}

TEST(Uri, ARecordingsKeysFitWhatItIsToCarry) {
  const auto misfit = [](const char* uri, Carries what) {
    return recording_misfit(parse_uri(uri).value(), what);
  };
  EXPECT_EQ(misfit("file:dive.cap?speed=1", Carries::bytes),
            "\"file:dive.cap?speed=1\": speed=1 needs the baud rate of the recorded line or "
            "clock=device, for example "
            "file:dive.log?speed=1&baud=38400");
  EXPECT_EQ(misfit("file:can.log?speed=2&format=asc&interface=can1", Carries::frames), "");
  EXPECT_EQ(misfit("file:dive.cap?format=trc", Carries::bytes),
            "\"file:dive.cap?format=trc\": format=trc is for CAN frames; for bytes there is raw");
  EXPECT_EQ(misfit("file:can.log?bitrate=500000&data_bitrate=2000000", Carries::frames), "");
  EXPECT_EQ(misfit("file:dive.cap?bitrate=500000", Carries::bytes),
            "\"file:dive.cap?bitrate=500000\": bitrate is for CAN frames; the rate of a line of "
            "bytes is baud");
  EXPECT_EQ(misfit("file:can.log?format=raw", Carries::frames),
            "\"file:can.log?format=raw\": format=raw is for bytes; for CAN frames there are "
            "pcap, pcapng, blf, candump-log, candump-screen, asc, trc, canboat, actisense, "
            "ydwg, ikonvert, savvycan, python-can, busmaster, crtd, ixxat, kvaser");
}

}  // namespace
}  // namespace drydock::link
