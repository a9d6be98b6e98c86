"""USB devices in software for the kernel's own drivers, at its virtual USB port (USB/IP, vhci-hcd). A program that has one gives it
orders, a line each, on standard input: plug | unplug, and those of the device."""
import os
import signal
import socket
import struct
import sys
import threading

VHCI = "/sys/devices/platform/vhci_hcd.0/"
FREE = 4  # state of a port: VDEV_ST_NULL, linux/usbip.h
HIGH_SPEED = 3  # USB_SPEED_HIGH, linux/usb/ch9.h
UNLINK = 2  # Documentation/usb/usbip_protocol.rst; the only other command submits a request
STALL, UNLINKED = -32, -104


def run(command):
    """By the shell: the module `subprocess` takes a second to load under emulation."""
    if os.system(command):
        raise RuntimeError(command)


def free_port():
    """The first port of the virtual hub for high speed that nothing is plugged into."""
    with open(VHCI + "status") as status:
        rows = [line.split() for line in status][1:]
    return next(int(row[1]) for row in rows if row[0] == "hs" and int(row[2]) == FREE)


class Device:
    """The requests of enumeration, and queues of the bulk pipes. A device has `vendor`, `model` and `pipes`; it answers its own
    control requests in control_of(), takes what the kernel sends to a pipe in sent(), and gives bytes to the kernel by give_now()."""
    product = "CAN adapter"
    release = 0x100
    stays = False  # in its port when the orders have ended

    def __init__(self):
        self.lock = threading.RLock()

    def plug(self):
        self.asked, self.ready = {}, {}
        self.pipe, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_STREAM)
        self.port = free_port()
        with open(VHCI + "attach", "w") as port:
            port.write(f"{self.port} {theirs.fileno()} 65537 {HIGH_SPEED}")  # 65537: the device's number
        theirs.close()
        threading.Thread(target=self.serve, args=(self.pipe,), daemon=True).start()

    def unplug(self):
        with open(VHCI + "detach", "w") as port:
            port.write(str(self.port))

    def obey(self, order, *words):
        if order not in ("plug", "unplug"):
            raise ValueError(order)
        getattr(self, order)()

    def descriptor(self, what, number):
        if what == 1:
            return struct.pack("<BBHBBBBHHHBBBB", 18, 1, 0x200, 0, 0, 0, 64, self.vendor, self.model, self.release, 1, 2, 3, 1)
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
            return self.control_of(request, value, data)
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

    def give_now(self, end, data):
        with self.lock:
            self.ready.setdefault(end, []).append(data)
            self.pump(end)

    def pump(self, end):
        asked, ready = self.asked.setdefault(end, []), self.ready.setdefault(end, [])
        while asked and ready:
            self.reply(asked.pop(0), data=ready.pop(0))


def serve_orders(device):
    for line in sys.stdin:
        device.obey(*line.split())
        print("done", line.strip(), flush=True)


def serve_and_stay(device):
    """A child serves the device for ever; this program ends with the orders."""
    ours, theirs = os.pipe()
    if os.fork():
        os.close(theirs)
        sys.exit(0 if os.read(ours, 1) else 1)
    serve_orders(device)
    os.write(theirs, b"0")
    signal.pause()


def main(device):
    (serve_and_stay if device.stays else serve_orders)(device)
