#!/usr/bin/env python3
"""USB CAN adapters in software, for the kernel's own drivers: usb_can.py gs_usb | usb_8dev

The adapter hangs at the kernel's virtual USB port (USB/IP, vhci-hcd). Its bus is in this program, so it shows what QEMU's
controllers lack: error states, bus-off, stamps of the controller, an adapter that is pulled out. Orders, a line each, on
standard input: plug | unplug | state CHANNEL NAME | late MILLISECONDS | fd CHANNEL | foreign CHANNEL COUNT
late: every second frame reaches the kernel so much later than its stamp says.
  gs_usb     two channels on one bus, CAN FD, stamps of the controller (1 us)     usb_8dev   one channel, restart-ms"""
import os
import signal
import socket
import struct
import sys
import threading
import time

VHCI = "/sys/devices/platform/vhci_hcd.0/"
FREE = 4  # state of a port: VDEV_ST_NULL, linux/usbip.h
SUBMIT, UNLINK = 1, 2  # Documentation/usb/usbip_protocol.rst
STALL, UNLINKED = -32, -104
NAMELESS = 0xFFFFFFFF  # gs_usb: a frame that the host did not send
# linux/can/error.h: identifiers of error frames, and byte 1 of one that tells a controller's state.
BUS_OFF, RESTARTED, STATE = 0x20000040, 0x20000100, 0x20000204
STATES = {"active": 0x40, "warning": 0x08, "passive": 0x20, "overflow": 0x01}


def run(command):
    """By the shell: the module `subprocess` takes a second to load under emulation."""
    if os.system(command):
        raise RuntimeError(command)


def free_port():
    """The first port of the virtual hub for high speed that nothing is plugged into."""
    with open(VHCI + "status") as status:
        rows = [line.split() for line in status][1:]
    return next(int(row[1]) for row in rows if row[0] == "hs" and int(row[2]) == FREE)


class Adapter:
    """A USB device behind the virtual port: the requests of enumeration, and queues of its bulk pipes."""
    product = "CAN adapter"
    stays = False  # in its port when the orders have ended

    def __init__(self):
        self.lock = threading.RLock()
        self.late_ms = 0

    def plug(self):
        self.asked, self.ready, self.odd = {}, {}, False
        self.pipe, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        self.port = free_port()
        with open(VHCI + "attach", "w") as port:
            port.write(f"{self.port} {theirs.fileno()} 65537 3")  # port, socket, device number, high speed
        theirs.close()
        threading.Thread(target=self.serve, args=(self.pipe,), daemon=True).start()

    def unplug(self):
        with open(VHCI + "detach", "w") as port:
            port.write(str(self.port))

    def descriptor(self, what, number):
        if what == 1:
            return struct.pack("<BBHBBBBHHHBBBB", 18, 1, 0x200, 0, 0, 0, 64, self.vendor, self.model, 0x100, 1, 2, 3, 1)
        if what == 2:
            pipes = b"".join(struct.pack("<BBBBHB", 7, 5, pipe, 2, 512, 0) for pipe in self.pipes)
            return (struct.pack("<BBHBBBBB", 9, 2, 18 + len(pipes), 1, 1, 0, 0x80, 50)
                    + bytes([9, 4, 0, 0, len(self.pipes), 255, 255, 255, 0]) + pipes)
        if what == 3:
            text = ["", "drydock", self.product, "1"][number].encode("utf-16le") if number else b"\x09\x04"
            return bytes([len(text) + 2, 3]) + text
        return None

    def control(self, setup, data):
        kind, request, value, _, _ = struct.unpack("<BBHHH", setup)
        if kind & 0x60:
            return self.order(request, value, data)
        return self.descriptor(value >> 8, value & 255) if (kind, request) == (0x80, 6) else b"\0\0"

    def take(self, pipe, size):
        data = b""
        while len(data) < size:
            piece = pipe.recv(size - len(data))
            if not piece:
                raise EOFError
            data += piece
        return data

    def reply(self, sequence, status=0, data=b"", length=None):
        length = len(data) if length is None else length
        self.pipe.sendall(struct.pack(">5I5i8x", 3, sequence, 0, 0, 0, status, length, 0, 0, 0) + data)

    def serve(self, pipe):
        try:
            while True:
                self.request(pipe, self.take(pipe, 48))
        except (EOFError, OSError):
            pass  # unplugged

    def request(self, pipe, head):
        command, sequence, _, inward, end = struct.unpack_from(">5I", head)
        with self.lock:
            if command == UNLINK:
                self.unlink(sequence, struct.unpack_from(">I", head, 20)[0])
                return
        length = struct.unpack_from(">i", head, 24)[0]
        data = b"" if inward else self.take(pipe, length)
        with self.lock:
            if end == 0:
                answer = self.control(head[40:48], data)
                self.reply(sequence, STALL if answer is None else 0, (answer or b"")[:length] if inward else b"",
                           None if inward or answer is None else length)
            elif inward:
                self.asked.setdefault(end, []).append(sequence)
                self.pump(end)
            else:
                self.reply(sequence, length=length)
                self.sent(end, data)

    def unlink(self, sequence, victim):
        waiting = [queue for queue in self.asked.values() if victim in queue]
        for queue in waiting:
            queue.remove(victim)
        self.pipe.sendall(struct.pack(">5Ii24x", 4, sequence, 0, 0, 0, UNLINKED if waiting else 0))

    def give(self, end, data):
        self.odd = not self.odd
        if self.late_ms and self.odd:
            threading.Timer(self.late_ms / 1e3, self.give_now, (end, data)).start()
        else:
            self.give_now(end, data)

    def give_now(self, end, data):
        with self.lock:
            self.ready.setdefault(end, []).append(data)
            self.pump(end)

    def pump(self, end):
        asked, ready = self.asked.setdefault(end, []), self.ready.setdefault(end, [])
        while asked and ready:
            self.reply(asked.pop(0), data=ready.pop(0))


class GsUsb(Adapter):
    """linux/drivers/net/can/usb/gs_usb.c: the layouts of its requests and of its frames."""
    vendor, model, pipes = 0x1D50, 0x606F, (0x81, 0x02)
    FEATURES = 1 | 16 | 256 | 1024  # listen-only, hardware timestamps, CAN FD, extended bit timing
    TIMING = (1, 256, 1, 128, 128, 1, 512, 1)  # segments, jump width, prescaler: smallest and largest of each
    open = {0: 0, 1: 0}

    def order(self, request, value, data):
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

    def sent(self, _, data):
        echo, identifier, dlc, channel, flags, _ = struct.unpack_from("<IIBBBB", data)
        self.give_now(1, self.frame(channel, echo, identifier, dlc, flags, data[12:]))
        if self.open[1 - channel]:
            self.give(1, self.frame(1 - channel, NAMELESS, identifier, dlc, flags, data[12:]))

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
                run(f"ip link set {name} down && ip link set {name} name left{self.port}")

    def order(self, request, value, data):
        return b""

    def sent(self, end, data):
        if end == 4:  # a command: 11h, channel, command, two bytes of option, ten of data, 22h
            self.give_now(3, bytes([0x11, 0, data[2], 0, 0]) + bytes([1, 1, 1, 1]).ljust(10, b"\0") + b"\x22")

    def foreign(self, _, identifier, dlc, flags, data):
        self.give_now(1, struct.pack(">BBBIB", 0x55, 0, 1, identifier, dlc) + data[:8].ljust(8, b"\0") + bytes(4) + b"\xaa")

    def state(self, _, name):
        body = bytes([self.NAMES[name], 0, 130]).ljust(8, b"\0")
        self.give_now(1, struct.pack(">BBBIB", 0x55, 3, 4, 0, 8) + body + bytes(4) + b"\xaa")


def obey(adapter, order, *words):
    if order in ("plug", "unplug"):
        getattr(adapter, order)()
    elif order == "state":
        adapter.state(int(words[0]), words[1])
    elif order == "late":
        adapter.late_ms = float(words[0])
    elif order == "fd":
        adapter.foreign(int(words[0]), 0x80000000 | 0x1DEFFF01, 15, 2 | 4, bytes(range(64)))
    elif order == "foreign":  # NMEA 2000 water depth (PGN 128267) of 10 m from address 35
        for number in range(int(words[1])):
            adapter.foreign(int(words[0]), 0x80000000 | 0x0DF50B23, 8, 0, struct.pack("<BIhB", number & 127, 1000, 0, 255))
    else:
        raise ValueError(order)


def serve_orders(adapter):
    for line in sys.stdin:
        obey(adapter, *line.split())
        print("done", line.strip(), flush=True)


def serve_and_stay(adapter):
    """A child serves the adapter for ever; this program ends with the orders."""
    ours, theirs = os.pipe()
    if os.fork():
        os.close(theirs)
        sys.exit(0 if os.read(ours, 1) else 1)
    serve_orders(adapter)
    os.write(theirs, b"0")
    signal.pause()


def main():
    adapter = {"gs_usb": GsUsb, "usb_8dev": Usb8dev}[sys.argv[1]]()
    (serve_and_stay if adapter.stays else serve_orders)(adapter)


main()
