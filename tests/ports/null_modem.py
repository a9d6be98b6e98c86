"""Null modems between pairs of serial ports of the machine in software, which by itself compares no rates and paces nothing.

Plain: bytes pass at once. Paced: a byte takes its time at the rate that the guest set, and a port at another rate reads other
bytes than were sent, as on a real line. QEMU passes the guest's rate to a pseudo-terminal, so a paced line has those for ends;
a pseudo-terminal keeps no parity and no number of data bits, so of these nothing is seen."""
import collections
import fcntl
import os
import random
import select
import socket
import termios
import threading
import time

RATE = {getattr(termios, name): int(name[1:]) for name in dir(termios) if name[0] == "B" and name[1:].isdigit()}
MOST_QUEUED = 1 << 20  # pieces on a line
MOST_UNREAD = 256  # bytes that wait in a paced line's port; a port that nobody has open loses what comes after them


class End:
    """One port's end of the line: `chardev` is what QEMU is told, `fd` what we read and write."""

    def __init__(self, paced, path):
        self.queue, self.free_at = collections.deque(), 0.0
        self.paced = paced
        if paced:
            self.fd, self.slave = os.openpty()
            os.set_blocking(self.fd, False)
            self.chardev = f"serial,path={os.ttyname(self.slave)}"
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
        """Rate in baud and bits of a character: start, eight data bits, stop. None on a plain line."""
        if not self.paced:
            return None
        flags, speed = termios.tcgetattr(self.fd)[2], termios.tcgetattr(self.fd)[5]
        return RATE.get(speed, 9600), 11 if flags & termios.CSTOPB else 10

    def unread(self):
        """Bytes that QEMU has not taken from the pseudo-terminal, since the guest does not read them."""
        return int.from_bytes(fcntl.ioctl(self.slave, termios.FIONREAD, bytes(4)), "little") if self.paced else 0


def carry(data, sender, receiver, noise, now):
    """Puts the bytes on the line: each arrives when its last bit has."""
    rate = sender.rate()
    if rate and rate != receiver.rate():
        data = bytes(noise.randrange(256) for _ in data if noise.random() < 0.7)
    seconds = rate[1] / rate[0] if rate else 0.0
    receiver.free_at = max(receiver.free_at, now)
    for byte in range(len(data)) if rate else [slice(None)]:
        receiver.free_at += seconds
        if len(receiver.queue) < MOST_QUEUED:
            receiver.queue.append((receiver.free_at, data[byte:byte + 1] if rate else data))


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
