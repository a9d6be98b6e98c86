"""Null modems between pairs of serial ports of the machine in software, which by itself compares no rates and paces nothing.

Plain: bytes pass at once. Paced: a byte takes its time at the rate that the guest set. A port at another rate reads other bytes
than were sent, and one with another parity or number of bits reads what a UART makes of the levels on the line (uart.py). QEMU passes the
guest's rate to a pseudo-terminal, so a paced line has those for ends. Parity, data and stop bits come by line_settings.c."""
import collections
import fcntl
import os
import pathlib
import random
import select
import socket
import termios
import threading
import time

import uart

RATE = {getattr(termios, name): int(name[1:]) for name in dir(termios) if name[0] == "B" and name[1:].isdigit()}
MOST_QUEUED = 1 << 20  # pieces on a line
LONGEST_CHARACTER = 12  # bits: start, eight data bits, parity, two stop bits
MOST_UNREAD = 256  # bytes that wait in a paced line's port; a port that nobody has open loses what comes after them


class End:
    """One port's end of the line: `chardev` is what QEMU is told, `fd` what we read and write."""

    def __init__(self, paced, path):
        self.queue, self.free_at = collections.deque(), 0.0
        self.pending = ""  # levels of a character that is not complete
        self.paced = paced
        if paced:
            self.fd, self.slave = os.openpty()
            os.set_blocking(self.fd, False)
            self.chardev = f"serial,path={os.ttyname(self.slave)}"
            self.flags_file = pathlib.Path(path).parent / pathlib.Path(os.ttyname(self.slave)).name
        else:
            self.listener = socket.socket(socket.AF_UNIX)
            self.listener.bind(path)
            self.listener.listen(1)
            self.chardev = f"socket,path={path}"

    def accept(self):
        if not self.paced:
            self.connection = self.listener.accept()[0]
            self.connection.setblocking(False)
            self.fd = self.connection.fileno()

    def rate(self):
        """In baud."""
        return RATE.get(termios.tcgetattr(self.fd)[5], 9600)

    def frame(self):
        """8N1 until the guest has set the port."""
        told = self.flags_file.read_bytes() if self.flags_file.exists() else b""
        flags = int.from_bytes(told, "little") if told else termios.CS8
        bits = {termios.CS5: 5, termios.CS6: 6, termios.CS7: 7}.get(flags & termios.CSIZE, 8)
        parity = ("O" if flags & termios.PARODD else "E") if flags & termios.PARENB else "N"
        return uart.Frame(bits, parity, 2 if flags & termios.CSTOPB else 1)

    def unread(self):
        """Bytes that QEMU has not taken from the pseudo-terminal, since the guest does not read them."""
        return int.from_bytes(fcntl.ioctl(self.slave, termios.FIONREAD, bytes(4)), "little") if self.paced else 0


def pass_on(receiver, at, data):
    if data and len(receiver.queue) < MOST_QUEUED:
        receiver.queue.append((at, data))


def carry(data, sender, receiver, noise, now):
    """Puts the bytes on the line: each arrives when its last bit has."""
    if not sender.paced:
        return pass_on(receiver, now, data)
    rate, sent, heard = sender.rate(), sender.frame(), receiver.frame()
    bit_s, other_rate = 1 / rate, rate != receiver.rate()
    idle = max(0.0, now - receiver.free_at) / bit_s
    receiver.pending, late = uart.heard(receiver.pending, "1" * int(min(idle, LONGEST_CHARACTER)), heard)
    receiver.free_at = max(receiver.free_at, now)
    pass_on(receiver, receiver.free_at, late)
    for byte in data:
        levels = uart.sent(byte, sent)
        receiver.free_at += len(levels) * bit_s
        if other_rate:
            pass_on(receiver, receiver.free_at, bytes([noise.randrange(256)]) if noise.random() < 0.7 else b"")
        else:
            receiver.pending, read = uart.heard(receiver.pending, levels, heard)
            pass_on(receiver, receiver.free_at, read)


def deliver(end, now):
    """Hands over what has arrived. False if the reader has to become ready first."""
    ripe = b""
    while end.queue and end.queue[0][0] <= now and len(ripe) < 4096:
        ripe += end.queue.popleft()[1]
    if end.unread() > MOST_UNREAD:
        return True
    try:
        written = os.write(end.fd, ripe) if ripe else 0
    except BlockingIOError:
        written = 0
    if written < len(ripe):
        end.queue.appendleft((now, ripe[written:]))
    return written == len(ripe)


class NullModem(threading.Thread):
    def __init__(self, paced, paths):
        super().__init__(daemon=True)
        self.ends = [End(paced, path) for path in paths]

    def run(self):
        for end in self.ends:
            end.accept()
        noise, live = random.Random(1), set(self.ends)
        while live:
            now = time.monotonic()
            blocked = [e for e in live if not deliver(e, now)]
            due = [e.queue[0][0] - now for e in live if e.queue and e not in blocked]
            readable, _, _ = select.select([e.fd for e in live], [e.fd for e in blocked], [], max(0.001, min(due, default=0.5)))
            for i, end in enumerate(self.ends):
                if end in live and end.fd in readable:
                    try:
                        data = os.read(end.fd, 65536)
                    except OSError:
                        data = b""
                    if data:
                        carry(data, end, self.ends[i ^ 1], noise, time.monotonic())
                    else:
                        live.discard(end)
