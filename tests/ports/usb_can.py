#!/usr/bin/env python3
"""USB CAN adapters in software, for the kernel's own drivers: usb_can.py gs_usb | usb_8dev

Its bus is in this program, so it shows what QEMU's controllers lack: error states, bus-off, stamps of the controller, an adapter
that is pulled out. Its orders beside those of usb_device.py: state CHANNEL NAME | late MILLISECONDS | fd CHANNEL |
foreign CHANNEL COUNT. late: every second frame reaches the kernel so much later than its stamp says.
  gs_usb     two channels on one bus, CAN FD, stamps of the controller (1 us)     usb_8dev   one channel, restart-ms"""
import os
import struct
import sys
import threading
import time

import usb_device

NAMELESS = 0xFFFFFFFF  # gs_usb: a frame that the host did not send
# linux/can/error.h: identifiers of error frames, and byte 1 of one that tells a controller's state.
BUS_OFF, RESTARTED, STATE = 0x20000040, 0x20000100, 0x20000204
STATES = {"active": 0x40, "warning": 0x08, "passive": 0x20, "overflow": 0x01}


class Adapter(usb_device.Device):
    """A controller says frames of others by foreign(), and its own state by state()."""

    def obey(self, order, *words):
        if order == "state":
            self.state(int(words[0]), words[1])
        elif order == "late":
            self.late_ms = float(words[0])
        elif order == "fd":
            self.foreign(int(words[0]), 0x80000000 | 0x1DEFFF01, 15, 2 | 4, bytes(range(64)))
        elif order == "foreign":  # NMEA 2000 water depth (PGN 128267) of 10 m from address 35
            for number in range(int(words[1])):
                self.foreign(int(words[0]), 0x80000000 | 0x0DF50B23, 8, 0, struct.pack("<BIhB", number & 127, 1000, 0, 255))
        else:
            super().obey(order, *words)


class GsUsb(Adapter):
    """linux/drivers/net/can/usb/gs_usb.c: the layouts of its requests and of its frames."""
    vendor, model, pipes = 0x1D50, 0x606F, (0x81, 0x02)
    FEATURES = 1 | 16 | 256 | 1024  # listen-only, hardware timestamps, CAN FD, extended bit timing
    TIMING = (1, 256, 1, 128, 128, 1, 512, 1)  # segments, jump width, prescaler: smallest and largest of each
    late_ms, odd = 0, False

    def __init__(self):
        super().__init__()
        self.open = {0: 0, 1: 0}

    def control_of(self, request, value, data):
        if request == 2:
            self.open[value] = struct.unpack_from("<I", data)[0]
        answers = {4: struct.pack("<10I", self.FEATURES, 80_000_000, *self.TIMING), 5: struct.pack("<4B2I", 0, 0, 0, 1, 2, 1),
                   6: struct.pack("<I", self.now()), 11: struct.pack("<18I", self.FEATURES, 80_000_000, *self.TIMING, *self.TIMING)}
        return answers.get(request, b"")

    def now(self):
        return time.monotonic_ns() // 1000 & 0xFFFFFFFF

    def frame(self, channel, echo, identifier, dlc, flags, data):
        size = 64 if flags & 2 else 8
        return (struct.pack("<IIBBBB", echo, identifier, dlc, channel, flags, 0) + data[:size].ljust(size, b"\0")
                + struct.pack("<I", self.now()))

    def give(self, data):
        self.odd = not self.odd
        if self.late_ms and self.odd:
            threading.Timer(self.late_ms / 1e3, self.give_now, (1, data)).start()
        else:
            self.give_now(1, data)

    def sent(self, _, data):
        echo, identifier, dlc, channel, flags, _ = struct.unpack_from("<IIBBBB", data)
        self.give_now(1, self.frame(channel, echo, identifier, dlc, flags, data[12:]))
        if self.open[1 - channel]:
            self.give(self.frame(1 - channel, NAMELESS, identifier, dlc, flags, data[12:]))

    def foreign(self, channel, identifier, dlc, flags, data):
        self.give_now(1, self.frame(channel, NAMELESS, identifier, dlc, flags, data))

    def state(self, channel, name):
        identifier = {"off": BUS_OFF, "restarted": RESTARTED}.get(name, STATE)
        self.foreign(channel, identifier, 8, 0, bytes([0, STATES.get(name, 0), 0, 0, 0, 0, 130, 0]))


class Usb8dev(Adapter):
    """linux/drivers/net/can/usb/usb_8dev.c: commands at pipe 4, frames at pipe 2; bus-off is the kernel's to end.
    Linux 6.1's driver frees its receive buffers twice where an adapter that was up is pulled out, and other programs then crash in
    the kernel. So `unplug` only takes the interface down and its name away, and the adapter stays until the machine ends."""
    stays = True
    vendor, model, pipes, product = 0x0483, 0x1234, (0x81, 0x02, 0x83, 0x04), "USB2CAN converter"
    NAMES = {"active": 0, "overflow": 1, "warning": 2, "passive": 3, "off": 4}

    def unplug(self):
        for name in os.listdir("/sys/class/net"):
            if name.startswith("can") and os.path.realpath(f"/sys/class/net/{name}/device/driver").endswith("usb_8dev"):
                usb_device.run(f"ip link set {name} down && ip link set {name} name left{self.port}")

    def control_of(self, request, value, data):
        return b""

    def sent(self, end, data):
        if end == 4:  # a command: 11h, channel, command, two bytes of option, ten of data, 22h
            self.give_now(3, bytes([0x11, 0, data[2], 0, 0]) + bytes([1, 1, 1, 1]).ljust(10, b"\0") + b"\x22")

    def foreign(self, _, identifier, dlc, flags, data):
        self.give_now(1, struct.pack(">BBBIB", 0x55, 0, 1, identifier, dlc) + data[:8].ljust(8, b"\0") + bytes(4) + b"\xaa")

    def state(self, _, name):
        body = bytes([self.NAMES[name], 0, 130]).ljust(8, b"\0")
        self.give_now(1, struct.pack(">BBBIB", 0x55, 3, 4, 0, 8) + body + bytes(4) + b"\xaa")


usb_device.main({"gs_usb": GsUsb, "usb_8dev": Usb8dev}[sys.argv[1]]())
